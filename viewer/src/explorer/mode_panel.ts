import type { Report } from '../model/report';
import { element } from '../ui/element';
import type { State, Store } from './state';

const most = 3;
const playedSd = 2;
const playedSeconds = 4;

interface Row {
  slider: HTMLInputElement;
  number: HTMLInputElement;
  play: HTMLButtonElement;
}

/** A slider and a number for every mode, in standard deviations. */
export class ModePanel {
  readonly root: HTMLElement;
  private readonly rows: Row[];
  private playing: number | null = null;

  constructor(
    private readonly report: Report,
    private readonly store: Store,
  ) {
    this.rows = report.model.varianceShares.map((_, m) => this.row(m));
    const list = element('ol', { class: 'modes' }, ...this.rows.map((row, m) => this.item(row, m)));
    const reset = element(
      'button',
      { type: 'button', onclick: () => this.set(this.rows.map(() => 0)) },
      'Reset to the mean',
    );
    const draw = element(
      'button',
      {
        type: 'button',
        title: 'Scores drawn at random, each within ±3 sd',
        onclick: () => this.set(this.rows.map(normalScore)),
      },
      'Random shape',
    );
    const note =
      report.model.modesLeftOut > 0
        ? [element('p', { class: 'note' }, `The ${report.model.modesLeftOut} weakest modes are left out of this page.`)]
        : [];
    this.root = element(
      'div',
      { class: 'mode-panel' },
      element('div', { class: 'buttons' }, reset, draw),
      list,
      ...note,
    );
    store.subscribe((state, changed) => {
      if (changed.has('scores')) this.follow(state);
      if (changed.has('tab')) this.play(null);
    });
  }

  private row(m: number): Row {
    const label = `Score of mode ${m + 1}, standard deviations`;
    const slider = element('input', {
      type: 'range',
      min: String(-most),
      max: String(most),
      step: '0.05',
      value: '0',
      aria: { label },
    });
    const number = element('input', {
      type: 'number',
      min: String(-most),
      max: String(most),
      step: '0.1',
      value: '0.0',
      aria: { label: `${label}, as a number` },
    });
    const play = element('button', {
      type: 'button',
      class: 'play',
      aria: { label: `Play mode ${m + 1}`, pressed: 'false' },
    });
    slider.addEventListener('input', () => this.setOne(m, Number(slider.value)));
    slider.addEventListener('dblclick', () => this.setOne(m, 0));
    number.addEventListener('input', () => {
      if (number.value !== '' && number.checkValidity()) this.setOne(m, Number(number.value));
    });
    number.addEventListener('change', () => this.setOne(m, Math.min(most, Math.max(-most, Number(number.value)))));
    play.addEventListener('click', () => this.play(this.playing === m ? null : m));
    return { slider, number, play };
  }

  private item({ slider, number, play }: Row, m: number): HTMLElement {
    const share = this.report.model.varianceShares[m];
    const bar = element('span', { class: 'share', title: `${(100 * share).toFixed(1)} % of all variation` });
    bar.style.setProperty('--share', String(share / this.report.model.varianceShares[0]));
    const name = element(
      'span',
      { class: 'mode-name' },
      `Mode ${m + 1}`,
      element('small', {}, `${(100 * share).toFixed(share < 0.0995 ? 1 : 0)} %`),
      bar,
    );
    return element('li', {}, name, slider, number, play);
  }

  private setOne(mode: number, score: number): void {
    this.play(null);
    this.store.update({ scores: this.store.state.scores.map((s, m) => (m === mode ? score : s)), strengthMode: mode });
  }

  private set(scores: number[]): void {
    this.play(null);
    this.store.update({ scores });
  }

  private follow(state: State): void {
    state.scores.forEach((score, m) => {
      const { slider, number } = this.rows[m];
      if (Number(slider.value) !== score) slider.value = String(score);
      if (Number(number.value) !== score) number.value = score.toFixed(Number.isInteger(score * 10) ? 1 : 2);
    });
  }

  // Animates one mode, from end to end, until the user makes another choice.
  private play(mode: number | null): void {
    if (this.playing === mode) return;
    if (this.playing !== null) this.rows[this.playing].play.setAttribute('aria-pressed', 'false');
    this.playing = mode;
    if (mode === null) return;
    this.rows[mode].play.setAttribute('aria-pressed', 'true');
    const begun = performance.now(),
      phase = Math.asin(Math.max(-1, Math.min(1, this.store.state.scores[mode] / playedSd)));
    const step = (now: number) => {
      if (this.playing !== mode) return;
      const swing = playedSd * Math.sin(phase + (2 * Math.PI * (now - begun)) / 1000 / playedSeconds);
      this.store.update({
        scores: this.store.state.scores.map((s, m) => (m === mode ? Math.round(100 * swing) / 100 : s)),
        strengthMode: mode,
      });
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}

// A normal random number by Box and Muller. It is drawn again if it is beyond the ends of the sliders.
function normalScore(): number {
  for (;;) {
    const score = Math.sqrt(-2 * Math.log(1 - Math.random())) * Math.cos(2 * Math.PI * Math.random());
    if (Math.abs(score) <= most) return Math.round(100 * score) / 100;
  }
}
