import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, OrthographicCamera, Scene, WebGLRenderer } from 'three';
import type { Loop } from '../model/loop';
import type { Report } from '../model/report';
import { element } from '../ui/element';
import { svg } from '../ui/svg';
import { SurfaceMaterial } from './material';
import { loopColours } from './ramp';
import type { Shown } from './shown';
import type { State, Store } from './state';
import { markFlipped, spread } from './surface_mesh';
import { copiesOverDomain, TorusLayout } from './torus_layout';

// Of the picture's larger side, on each side of the domain.
const margin = 0.015;
const mostPixelRatio = 2;

/** The flat torus: the surface of the model spread out, in the same colours. */
export class TorusView {
  readonly root = element('div', { class: 'torus' });
  private readonly canvas = element('canvas', { role: 'img', aria: { label: 'The surface laid out on the flat torus, in the same colours' } });
  private readonly renderer: WebGLRenderer;
  private readonly material: SurfaceMaterial;
  private readonly scene = new Scene();
  private readonly camera: OrthographicCamera;
  private readonly layout: TorusLayout;
  private readonly cornerLandmarks: Uint32Array;
  private readonly triangleCopies: Map<number, number[]>;
  private readonly value: BufferAttribute;
  private readonly flipped: BufferAttribute;
  private readonly loops: SVGElement;
  private readonly mark = svg('circle', { class: 'torus-mark', r: 0.014 });
  private readonly box: { x: number; y: number; width: number; height: number };

  constructor(private readonly report: Report, private readonly store: Store, cells: [number, number], private readonly redraw: () => void) {
    const { torus, model } = report;
    this.layout = new TorusLayout(torus);
    const { low, high } = this.layout;
    const edge = margin * Math.max(high[0] - low[0], high[1] - low[1]);
    this.box = { x: low[0] - edge, y: low[1] - edge, width: high[0] - low[0] + 2 * edge, height: high[1] - low[1] + 2 * edge };

    const copies = copiesOverDomain(torus.cornerTurns);
    this.cornerLandmarks = new Uint32Array(3 * copies.triangles.length);
    this.triangleCopies = new Map();
    copies.triangles.forEach((t, i) => {
      for (let k = 0; k < 3; ++k) this.cornerLandmarks[3 * i + k] = model.triangles[3 * t + k];
      this.triangleCopies.set(t, [...(this.triangleCopies.get(t) ?? []), i]);
    });
    const corners = this.cornerLandmarks.length;
    const position = new Float32Array(3 * corners);
    for (let i = 0; i < corners; ++i) position.set(this.layout.place(copies.turns[2 * i], copies.turns[2 * i + 1]), 3 * i);
    this.value = new BufferAttribute(new Float32Array(corners), 1).setUsage(DynamicDrawUsage);
    this.flipped = new BufferAttribute(new Float32Array(corners), 1).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(position, 3));
    geometry.setAttribute('normal', new BufferAttribute(new Float32Array(3 * corners), 3));
    geometry.setAttribute('value', this.value);
    geometry.setAttribute('flipped', this.flipped);
    geometry.setAttribute('turns', new BufferAttribute(copies.turns, 2));

    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.material = new SurfaceMaterial('torus', cells);
    this.scene.add(new Mesh(geometry, this.material));
    const { x, y, width, height } = this.box;
    this.camera = new OrthographicCamera(x, x + width, y + height, y, -1, 1);

    this.loops = svg('g', { 'clip-path': 'url(#torus-domain)' }, ...report.loops.map((loop, i) => this.loopPath(loop, loopColours[i % 2])));
    const outline = this.layout.corners.map((p) => this.inPicture(p).join(',')).join(' ');
    this.root.append(this.canvas, svg('svg', { viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true' },
      svg('clipPath', { id: 'torus-domain' }, svg('polygon', { points: outline })),
      svg('polygon', { points: outline, class: 'torus-outline' }), this.loops, this.mark));
    this.root.style.aspectRatio = `${width} / ${height}`;
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.root);
  }

  show(shown: Shown, state: State): void {
    const { triangles } = this.report.model;
    const surface = shown.surfaces[0];
    this.material.show(shown.colouring, shown.scale?.end ?? 1, state.edges);
    if (surface.values) spread(this.value.array as Float32Array, 1, surface.values, this.cornerLandmarks);
    const flipped = state.flips ? surface.flipped.filter((t) => 3 * t < triangles.length) : [];
    markFlipped(this.flipped.array as Float32Array, flipped.flatMap((t) => this.triangleCopies.get(t) ?? []));
    this.value.needsUpdate = this.flipped.needsUpdate = true;
    this.loops.setAttribute('visibility', state.loops ? 'visible' : 'hidden');
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

  draw(): void {
    this.renderer.render(this.scene, this.camera);
  }

  private resize(): void {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, mostPixelRatio));
    this.renderer.setSize(Math.max(1, this.root.clientWidth), Math.max(1, this.root.clientHeight), false);
    this.redraw();
  }

  // y downward, from the corner of the box.
  private inPicture([x, y]: [number, number]): [number, number] {
    return [x - this.box.x, this.box.height - (y - this.box.y)];
  }

  // The closed curve once in every copy of the domain around; what lies outside is clipped.
  private loopPath(loop: Loop, colour: string): SVGElement {
    const { cornerTurns } = this.report.torus;
    const turns = loop.along(2, (triangle, corner, c) => cornerTurns[2 * (3 * triangle + corner) + c]);
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
        path.push('M' + walk.map(([u, v]) => this.inPicture(this.layout.place(u + du, v + dv)).map((x) => x.toFixed(4)).join(' ')).join('L'));
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
