// The ratio of drawn pixels to pixels of the page, along one side. A ratio above 1 smooths edges. On slow machines it
// is smaller while the view moves.
const levels = [0.7, 1, 1.4, 2];
const best = levels.length - 1;
const slowFrame = 30,
  fastFrame = 20; // milliseconds
const slowFramesToTell = 3,
  fastFramesToTell = 30;
/** A picture that has not changed for this time [ms] is drawn again with the highest ratio. */
export const stillAfter = 200;

/** Chooses the ratio for the next frame from the time that the last frames took. */
export class Sharpness {
  private level = 1;
  private last = -Infinity;
  private slow = 0;
  private fast = 0;

  get sharpest(): number {
    return levels[best];
  }

  /** The ratio for a frame at this time [ms] while the view moves. */
  inMotion(now: number): number {
    const taken = now - this.last;
    this.last = now;
    if (taken < stillAfter) this.judge(taken); // a pause says nothing about the speed
    return levels[this.level];
  }

  private judge(taken: number): void {
    this.slow = taken > slowFrame ? this.slow + 1 : 0;
    this.fast = taken < fastFrame ? this.fast + 1 : 0;
    if (this.slow >= slowFramesToTell && this.level > 0) {
      this.level -= 1;
      this.slow = 0;
    } else if (this.fast >= fastFramesToTell && this.level < best) {
      this.level += 1;
      this.fast = 0;
    }
  }
}
