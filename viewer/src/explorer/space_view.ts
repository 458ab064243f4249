import { Box3, BufferAttribute, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { element } from '../ui/element';
import type { Report } from '../model/report';
import type { NamedView } from '../model/report_data';
import { sheetOf } from '../model/sheet';
import { firstHit } from '../model/surface';
import { Orbit } from './orbit';
import type { Shown } from './shown';
import type { State, Store } from './state';
import { sheetMaterials, type SheetMaterials } from './sheet_mesh';
import { SurfaceMesh } from './surface_mesh';

const fieldOfView = 26;
// A press that moves less than this is a click.
const clickPixels = 4;

/** The surfaces in space: one surface, or two beside each other, seen from the same side. */
export class SpaceView {
  readonly root = element('div', { class: 'space' });
  private readonly canvas = element('canvas', {
    tabIndex: 0,
    role: 'img',
    aria: { label: 'The model in three dimensions' },
  });
  private readonly titles = [0, 1].map(() => element('p', { class: 'surface-title' }));
  private readonly marks = [0, 1].map(() => element('span', { class: 'mark', hidden: true }));
  private readonly renderer: WebGLRenderer;
  private readonly materials: SheetMaterials;
  private readonly meshes: SurfaceMesh[];
  private readonly scenes: Scene[];
  private readonly cameras = [0, 1].map(() => new PerspectiveCamera(fieldOfView));
  private readonly orbit: Orbit;
  private panes = 1;
  private marked: number | null = null;

  /** Throws if the browser has no WebGL. */
  constructor(
    private readonly report: Report,
    private readonly store: Store,
    cells: [number, number],
    private readonly redraw: () => void,
  ) {
    this.renderer = new WebGLRenderer({ canvas: this.canvas, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setScissorTest(true);
    this.materials = sheetMaterials('lit', cells);
    const { torus, model } = report;
    const sheet = sheetOf(model.triangles, torus.cornerTurns, torus.turns);
    this.meshes = [0, 1].map(() => new SurfaceMesh(report, sheet, this.materials));
    this.scenes = this.meshes.map((mesh) => new Scene().add(mesh));
    this.orbit = new Orbit(this.canvas, ...ballOf(report.model.mean), report.data.views[0], redraw);
    this.root.append(this.canvas, ...this.titles, ...this.marks);
    this.canvas.addEventListener('contextmenu', (e) => e.preventDefault());
    this.canvas.addEventListener('pointermove', (e) => this.hover(e));
    this.canvas.addEventListener('pointerleave', () => store.update({ hovered: null }));
    this.pinOnClick();
    new ResizeObserver(() => this.resize()).observe(this.root);
  }

  lookFrom(view: NamedView): void {
    this.orbit.lookFrom(view);
  }

  show(shown: Shown, state: State): void {
    this.materials.surface.paint(
      shown.colouring,
      shown.scale?.end ?? 1,
      shown.surfaces.some((s) => s.flipped.length > 0),
    );
    this.panes = shown.surfaces.length;
    this.root.dataset.panes = String(this.panes);
    shown.surfaces.forEach((surface, i) => {
      this.meshes[i].show(surface, state);
      this.titles[i].textContent = surface.title;
    });
    this.canvas.setAttribute(
      'aria-label',
      `${shown.surfaces.map((s) => s.title || 'The model').join(' beside ')}. ${shown.status}`,
    );
  }

  mark(landmark: number | null): void {
    this.marked = landmark;
  }

  draw(pixelRatio: number): void {
    const { width, height } = this.size();
    this.renderer.setPixelRatio(pixelRatio);
    for (let i = 0; i < this.panes; ++i) {
      const left = (i * width) / this.panes;
      this.orbit.place(this.cameras[i], width / this.panes / height);
      this.renderer.setViewport(left, 0, width / this.panes, height);
      this.renderer.setScissor(left, 0, width / this.panes, height);
      this.renderer.render(this.scenes[i], this.cameras[i]);
    }
    this.marks.forEach((mark, i) => this.placeMark(mark, i));
  }

  private size() {
    return { width: Math.max(1, this.root.clientWidth), height: Math.max(1, this.root.clientHeight) };
  }

  // A new size clears the canvas, after this frame has been drawn. Drawing again immediately avoids an empty frame.
  private resize(): void {
    const { width, height } = this.size();
    this.renderer.setSize(width, height, false);
    this.draw(this.renderer.getPixelRatio());
    this.redraw();
  }

  private placeMark(mark: HTMLElement, pane: number): void {
    mark.hidden = this.marked === null || pane >= this.panes;
    if (this.marked === null || mark.hidden) return;
    const points = this.meshes[pane].points,
      camera = this.cameras[pane];
    const place = new Vector3().fromArray(points, 3 * this.marked);
    const eye = camera.position,
      sight = place.clone().sub(eye);
    const hit = firstHit(points, this.report.model.triangles, eye.toArray(), sight.toArray());
    mark.classList.toggle('behind', hit !== null && hit.at < 0.995);
    const seen = place.project(camera);
    const { width, height } = this.size();
    mark.style.left = `${((pane + (seen.x + 1) / 2) * width) / this.panes}px`;
    mark.style.top = `${((1 - seen.y) / 2) * height}px`;
  }

  private landmarkAt(e: PointerEvent): number | null {
    const box = this.canvas.getBoundingClientRect();
    const across = ((e.clientX - box.left) / box.width) * this.panes;
    const pane = Math.min(this.panes - 1, Math.max(0, Math.floor(across)));
    const camera = this.cameras[pane];
    const there = new Vector3(2 * (across - pane) - 1, 1 - (2 * (e.clientY - box.top)) / box.height, 0.5).unproject(
      camera,
    );
    const direction = there.sub(camera.position);
    return (
      firstHit(this.meshes[pane].points, this.report.model.triangles, camera.position.toArray(), direction.toArray())
        ?.landmark ?? null
    );
  }

  private hover(e: PointerEvent): void {
    if (!this.orbit.isDragging) this.store.update({ hovered: this.landmarkAt(e) });
  }

  private pinOnClick(): void {
    let pressed: PointerEvent | null = null;
    this.canvas.addEventListener('pointerdown', (e) => (pressed = e));
    this.canvas.addEventListener('pointerup', (e) => {
      if (pressed && Math.hypot(e.clientX - pressed.clientX, e.clientY - pressed.clientY) < clickPixels)
        this.store.update({ pinned: this.landmarkAt(e) });
      pressed = null;
    });
  }
}

// A sphere around all points, centred at the middle of their bounding box.
function ballOf(points: Float32Array): [Vector3, number] {
  const all = new BufferAttribute(points, 3);
  const middle = new Box3().setFromBufferAttribute(all).getCenter(new Vector3());
  let radius = 0;
  for (let i = 0; i < all.count; ++i)
    radius = Math.max(radius, middle.distanceTo(new Vector3().fromBufferAttribute(all, i)));
  return [middle, radius];
}
