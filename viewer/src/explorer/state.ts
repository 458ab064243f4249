import type { Report } from '../model/report';

export type Tab = 'modes' | 'shapes';

/** What the colours of the surface mean. */
export type Colouring = 'plain' | 'displacement' | 'strength' | 'error' | 'fit' | 'torus' | 'checkerboard';

export interface State {
  tab: Tab;
  /** Of the sliders, in standard deviations. */
  scores: number[];
  /** The training shape that is shown, and the number of modes of the fit beside it. */
  shape: number;
  fitModes: number;
  /** Each tab keeps its own. */
  colouring: Record<Tab, Colouring>;
  /** Whose strength is coloured, and named in the control. */
  strengthMode: number;
  loops: boolean;
  edges: boolean;
  flips: boolean;
  /** Marked in both views. `pinned` stays when the pointer leaves. */
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
    pinned: null,
    hovered: null,
  };
}

/** The one place where the explorer's state is kept and changed. */
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
