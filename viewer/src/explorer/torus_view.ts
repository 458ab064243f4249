import { BufferAttribute, OrthographicCamera, Scene, WebGLRenderer } from 'three';
import type { Report } from '../model/report';
import { sheetOf } from '../model/sheet';
import type { SurfacePoints } from '../model/surface_points';
import { element } from '../ui/element';
import { svg } from '../ui/svg';
import { loopColours } from './ramp';
import { SheetMesh, sheetMaterials, type SheetMaterials } from './sheet_mesh';
import type { Shown } from './shown';
import type { State, Store } from './state';
import { copiesOverDomain, TorusLayout } from './torus_layout';

// The margin on each side of the domain, as a share of the picture's larger side.
const margin = 0.015;

/** The flat torus: the map of the model's surface, in the same colours. */
export class TorusView {
  readonly root = element('div', { class: 'torus' });
  private readonly canvas = element('canvas', {
    role: 'img',
    aria: { label: 'The surface laid out on the flat torus, coloured alike' },
  });
  private readonly renderer: WebGLRenderer;
  private readonly materials: SheetMaterials;
  private readonly mesh: SheetMesh;
  private readonly scene = new Scene();
  private readonly camera: OrthographicCamera;
  private readonly layout: TorusLayout;
  // For each triangle of the model, its copies in the sheet.
  private readonly copiesOf = new Map<number, number[]>();
  private readonly loops: SVGElement;
  // What the mesh shows, and the pixel ratio with which it was drawn; 0 if it has not been drawn.
  private content: unknown[] = [];
  private drawnAt = 0;
  private readonly mark = svg('circle', { class: 'torus-mark', r: 0.014 });
  private readonly box: { x: number; y: number; width: number; height: number };

  constructor(
    private readonly report: Report,
    private readonly store: Store,
    cells: [number, number],
    private readonly redraw: () => void,
  ) {
    const { torus, model } = report;
    this.layout = new TorusLayout(torus);
    const { low, high } = this.layout;
    const edge = margin * Math.max(high[0] - low[0], high[1] - low[1]);
    this.box = {
      x: low[0] - edge,
      y: low[1] - edge,
      width: high[0] - low[0] + 2 * edge,
      height: high[1] - low[1] + 2 * edge,
    };

    const copies = copiesOverDomain(torus.cornerTurns);
    const cornerLandmarks = new Uint32Array(3 * copies.triangles.length);
    copies.triangles.forEach((t, i) => {
      cornerLandmarks.set(model.triangles.subarray(3 * t, 3 * t + 3), 3 * i);
      this.copiesOf.set(t, [...(this.copiesOf.get(t) ?? []), i]);
    });
    const sheet = sheetOf(cornerLandmarks, copies.turns, torus.turns);
    const places = new Float32Array(3 * sheet.landmarks.length);
    for (let i = 0; i < sheet.landmarks.length; ++i)
      places.set(this.layout.place(sheet.turns[2 * i], sheet.turns[2 * i + 1]), 3 * i);
    this.materials = sheetMaterials('flat', cells);
    this.mesh = new SheetMesh(sheet, this.materials, new BufferAttribute(places, 3), null);
    this.scene.add(this.mesh);

    this.renderer = new WebGLRenderer({ canvas: this.canvas, alpha: true, preserveDrawingBuffer: true });
    const { x, y, width, height } = this.box;
    this.camera = new OrthographicCamera(x, x + width, y + height, y, -1, 1);

    this.loops = svg(
      'g',
      { 'clip-path': 'url(#torus-domain)' },
      ...report.loops.map((loop, i) => this.loopPath(loop, loopColours[i % 2])),
    );
    const outline = this.layout.corners.map((p) => this.inPicture(p).join(',')).join(' ');
    this.root.append(
      this.canvas,
      svg(
        'svg',
        { viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true' },
        svg('clipPath', { id: 'torus-domain' }, svg('polygon', { points: outline })),
        svg('polygon', { points: outline, class: 'torus-outline' }),
        this.loops,
        this.mark,
      ),
    );
    const percent = (p: [number, number]) => `${(100 * p[0]) / width}% ${(100 * p[1]) / height}%`;
    this.canvas.style.clipPath = `polygon(${this.layout.corners.map((p) => percent(this.inPicture(p))).join(',')})`;
    this.root.style.aspectRatio = `${width} / ${height}`;
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.root);
  }

  show(shown: Shown, state: State): void {
    this.loops.setAttribute('visibility', state.loops ? 'visible' : 'hidden');
    const { values, flipped } = shown.surfaces[0];
    const content = [
      shown.colouring,
      shown.scale?.end,
      values,
      state.flips,
      flipped.length === 0 ? 'none' : flipped,
      state.edges,
    ];
    if (content.every((part, i) => part === this.content[i])) return;
    this.content = content;
    this.drawnAt = 0;
    this.materials.surface.paint(shown.colouring, shown.scale?.end ?? 1, false);
    this.mesh.show(values, state.flips ? flipped.flatMap((t) => this.copiesOf.get(t) ?? []) : [], state.edges);
  }

  placeMark(landmark: number | null): void {
    this.mark.setAttribute('visibility', landmark === null ? 'hidden' : 'visible');
    if (landmark === null) return;
    const { turns } = this.report.torus;
    const wrapped = (t: number) => t - Math.floor(t);
    const [x, y] = this.inPicture(this.layout.place(wrapped(turns[2 * landmark]), wrapped(turns[2 * landmark + 1])));
    this.mark.setAttribute('cx', String(x));
    this.mark.setAttribute('cy', String(y));
  }

  /** Draws only what is new or was drawn with a lower pixel ratio. */
  draw(pixelRatio: number): void {
    if (this.drawnAt >= pixelRatio) return;
    this.drawnAt = pixelRatio;
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.render(this.scene, this.camera);
  }

  // Drawn immediately, as in SpaceView.
  private resize(): void {
    this.drawnAt = 0;
    this.renderer.setSize(Math.max(1, this.root.clientWidth), Math.max(1, this.root.clientHeight), false);
    this.draw(this.renderer.getPixelRatio());
    this.redraw();
  }

  // The place with y downward, from the corner of the box.
  private inPicture([x, y]: [number, number]): [number, number] {
    return [x - this.box.x, this.box.height - (y - this.box.y)];
  }

  // The closed curve is drawn in each neighbouring copy of the domain, and clipped to the domain.
  private loopPath(loop: SurfacePoints, colour: string): SVGElement {
    const { cornerTurns } = this.report.torus;
    const turns = loop.values(2, (triangle, corner, c) => cornerTurns[2 * (3 * triangle + corner) + c]);
    const at = [turns[0], turns[1]];
    const walk: [number, number][] = [[at[0], at[1]]];
    for (let i = 1; i <= loop.length; ++i) {
      for (let c = 0; c < 2; ++c) {
        const step = turns[2 * (i % loop.length) + c] - at[c];
        at[c] += step - Math.round(step);
      }
      walk.push([at[0], at[1]]);
    }
    const path: string[] = [];
    for (const du of [-2, -1, 0, 1, 2])
      for (const dv of [-2, -1, 0, 1, 2])
        path.push(
          'M' +
            walk
              .map(([u, v]) =>
                this.inPicture(this.layout.place(u + du, v + dv))
                  .map((x) => x.toFixed(4))
                  .join(' '),
              )
              .join('L'),
        );
    return svg('path', { d: path.join(''), stroke: colour, class: 'torus-loop' });
  }

  private landmarkAt(e: PointerEvent | MouseEvent): number | null {
    const frame = this.canvas.getBoundingClientRect();
    const x = this.box.x + ((e.clientX - frame.left) / frame.width) * this.box.width;
    const y = this.box.y + (1 - (e.clientY - frame.top) / frame.height) * this.box.height;
    const [u, v] = this.layout.turnsAt(x, y);
    if (u < 0 || u > 1 || v < 0 || v > 1) return null;
    return this.report.torus.nearestLandmark(u, v);
  }

  private listen(): void {
    this.canvas.addEventListener('pointermove', (e) => this.store.update({ hovered: this.landmarkAt(e) }));
    this.canvas.addEventListener('pointerleave', () => this.store.update({ hovered: null }));
    this.canvas.addEventListener('click', (e) => this.store.update({ pinned: this.landmarkAt(e) }));
  }
}
