import type { Report } from '../model/report';

export type Tab = 'modes' | 'shapes';

/** The meaning of the colours of the surface. */
export type Colouring = 'plain' | 'displacement' | 'strength' | 'error' | 'fit' | 'torus' | 'checkerboard';

export interface State {
  tab: Tab;
  /** The scores of the sliders, in standard deviations. */
  scores: number[];
  /** The training shape that is shown, and the number of modes of the fit beside it. */
  shape: number;
  fitModes: number;
  /** Each tab has its own colouring. */
  colouring: Record<Tab, Colouring>;
  /** The mode whose strength is shown by colours and which the control names. */
  strengthMode: number;
  loops: boolean;
  edges: boolean;
  flips: boolean;
  marks: boolean;
  /** The mark that is drawn alone; null if all are drawn. */
  onlyMark: number | null;
  /** The landmark that is marked in both views. If `pinned`, the mark stays when the pointer leaves. */
  pinned: number | null;
  hovered: number | null;
}

export function initialState(report: Report): State {
  return {
    tab: 'modes',
    scores: new Array<number>(report.model.modes).fill(0),
    shape: 0,
    fitModes: Math.min(report.model.modes, Math.max(1, Math.floor(report.model.modes / 2))),
    colouring: { modes: 'strength', shapes: 'error' },
    strengthMode: 0,
    loops: false,
    edges: false,
    flips: true,
    marks: true,
    onlyMark: null,
    pinned: null,
    hovered: null,
  };
}

/** Holds the state of the explorer. All changes of the state are made here. */
export class Store {
  private readonly listeners: ((state: State, changed: Set<keyof State>) => void)[] = [];

  constructor(public readonly state: State) {}

  subscribe(listener: (state: State, changed: Set<keyof State>) => void): void {
    this.listeners.push(listener);
  }

  update(change: Partial<State>): void {
    const changed = new Set<keyof State>();
    for (const key of Object.keys(change) as (keyof State)[]) if (this.state[key] !== change[key]) changed.add(key);
    if (changed.size === 0) return;
    Object.assign(this.state, change);
    for (const listener of this.listeners) listener(this.state, changed);
  }
}
