import type { Report } from '../model/report';
import { plyOf } from '../model/ply';
import { element } from '../ui/element';
import { ColourPanel } from './colour_panel';
import { LandmarkPanel } from './landmark_panel';
import { Legend } from './legend';
import { MarkPanel } from './mark_panel';
import { ModePanel } from './mode_panel';
import { ShapePanel } from './shape_panel';
import { Exhibitor, type Shown } from './shown';
import { SpaceView } from './space_view';
import { Sharpness, stillAfter } from './sharpness';
import { initialState, Store, type State, type Tab } from './state';
import { tabs } from './tabs';
import { TorusView } from './torus_view';

const checkerCells = 320;
const announcedAfter = 700; // milliseconds

/** The interactive views of the model: the surface, the flat torus and the controls. */
export class Explorer {
  readonly root: HTMLElement;
  readonly store: Store;
  private readonly exhibitor: Exhibitor;
  private readonly space: SpaceView;
  private readonly torus: TorusView;
  private readonly legend = new Legend();
  private readonly landmark: LandmarkPanel;
  private readonly status = element('p', { class: 'status' });
  private readonly announcement = element('p', { class: 'visually-hidden', role: 'status' });
  private shown: Shown;
  private frame = 0;
  private stale = true;
  private announcing = 0;
  private readonly sharpness = new Sharpness();
  private sharpening = 0;

  /** Throws if the browser has no WebGL. */
  constructor(
    private readonly report: Report,
    private readonly drawn: (sharp: boolean) => void,
  ) {
    this.store = new Store(initialState(report));
    this.exhibitor = new Exhibitor(report);
    this.shown = this.exhibitor.shown(this.store.state);
    const cells = checkerboard(report.torus.lattice);
    const redraw = () => this.schedule();
    this.space = new SpaceView(report, this.store, cells, redraw);
    this.torus = new TorusView(report, this.store, cells, redraw);
    this.landmark = new LandmarkPanel(report, this.store);
    this.store.subscribe((_, changed) => {
      if ([...changed].some((key) => key !== 'hovered' && key !== 'pinned')) this.stale = true;
      this.schedule();
    });
    this.root = this.layout();
    addEventListener('beforeprint', () => this.draw(true));
  }

  /** Shows a training shape. */
  showShape(shape: number): void {
    this.store.update({ tab: 'shapes', shape });
    this.root.scrollIntoView({ block: 'start' });
  }

  /** Draws what has changed, and draws it again at full resolution when it no longer changes. */
  draw(sharp = false): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.sharpening);
    this.frame = 0;
    const { state } = this.store;
    if (this.stale) {
      this.stale = false;
      this.shown = this.exhibitor.shown(state);
      this.space.show(this.shown, state);
      this.torus.show(this.shown, state);
      this.legend.show(this.shown, state);
      this.status.textContent = this.shown.status;
      this.announce(this.shown.status);
    }
    const marked = state.hovered ?? state.pinned;
    this.space.mark(marked);
    this.torus.placeMark(marked);
    this.landmark.show(this.shown, state);
    const ratio = sharp ? this.sharpness.sharpest : this.sharpness.inMotion(performance.now());
    this.space.draw(ratio);
    this.torus.draw(ratio);
    this.drawn(sharp);
    if (!sharp) this.sharpening = window.setTimeout(() => this.draw(true), stillAfter);
  }

  private schedule(): void {
    this.frame ||= requestAnimationFrame(() => this.draw());
  }

  // Screen readers announce only the end of a movement, not every step of it.
  private announce(text: string): void {
    clearTimeout(this.announcing);
    this.announcing = window.setTimeout(() => (this.announcement.textContent = text), announcedAfter);
  }

  private layout(): HTMLElement {
    const { report, store } = this;
    const views = report.data.views.map((view) =>
      element('button', { type: 'button', onclick: () => this.space.lookFrom(view) }, view.name),
    );
    const hints = [
      element(
        'p',
        { class: 'hint' },
        'Drag to turn, Shift and drag to move, click and then scroll to zoom; or arrow keys, + − 0.',
      ),
      element('p', { class: 'hint touch' }, 'One finger turns, two move and zoom; tap to mark a landmark.'),
    ];
    const stage = element(
      'div',
      { class: 'stage' },
      this.space.root,
      element('div', { class: 'view-buttons', role: 'group', aria: { label: 'Look from' } }, ...views),
      this.legend.root,
    );
    const modes = new ModePanel(report, store),
      shapes = new ShapePanel(report, store);
    const panel = element(
      'div',
      { class: 'panel' },
      ...tabs<Tab>(
        [
          { key: 'modes', title: 'Modes', body: modes.root },
          { key: 'shapes', title: 'Training shapes', body: shapes.root },
        ],
        (tab) => store.update({ tab }),
        (listen) => store.subscribe((state: State) => listen(state.tab)),
      ),
      new ColourPanel(report, store).root,
      new MarkPanel(report, store).root,
      element(
        'figure',
        { class: 'torus-figure' },
        element('figcaption', {}, 'The same surface on the flat torus; its opposite borders are one line'),
        this.torus.root,
      ),
      this.landmark.root,
      element(
        'div',
        { class: 'buttons' },
        element('button', { type: 'button', onclick: () => this.save() }, 'Save this shape as PLY'),
      ),
    );
    return element(
      'section',
      { class: 'explorer', id: 'model', aria: { label: 'The model in motion' } },
      element('div', { class: 'show' }, stage, element('div', { class: 'under-stage' }, this.status, ...hints)),
      panel,
      this.announcement,
    );
  }

  private save(): void {
    const { state } = this.store;
    const name = state.tab === 'modes' ? 'model_shape' : this.report.shapes[state.shape].name;
    const address = URL.createObjectURL(
      plyOf(this.shown.surfaces[0].points, this.report.model.triangles, this.report.data.model.space),
    );
    element('a', { href: address, download: `${name}.ply` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
  }
}

// Nearly square cells, with an even number in each direction, so that the checkerboard has no seam.
function checkerboard([[a, b], [c, d]]: [[number, number], [number, number]]): [number, number] {
  const ratio = Math.hypot(b, d) / Math.hypot(a, c);
  const even = (cells: number) => Math.max(2, 2 * Math.round(cells / 2));
  return [even(Math.sqrt(checkerCells / ratio)), even(Math.sqrt(checkerCells * ratio))];
}
