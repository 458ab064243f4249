// Measures the speed of a report: REPORT=model/report.html npm run measure. It is not a part of the test suite.
import { statSync } from 'node:fs';
import { resolve } from 'node:path';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { launch, open, openDrawn } from '../support/browser';

const report = resolve(process.env.REPORT ?? 'REPORT is not set');
let browser: Browser;

beforeAll(async () => {
  browser = await launch();
});
afterAll(() => browser?.close());

it('opens in less than 3 s', async () => {
  const seconds: number[] = [];
  for (let i = 0; i < 5; ++i) {
    const begun = performance.now();
    const { page, close } = await open(browser, report);
    await page.waitForSelector('html[data-drawn]', { state: 'attached' });
    seconds.push((performance.now() - begun) / 1000);
    await close();
  }
  console.log(
    `${(statSync(report).size / 1e6).toFixed(1)} MB; seconds until drawn: ${seconds.map((s) => s.toFixed(2)).join(', ')}`,
  );
  expect(Math.max(...seconds)).toBeLessThan(3);
}, 60_000);

it.each(['strength', 'displacement'])(
  'follows a slider at 30 frames a second or more, coloured by %s',
  async (colouring) => {
    const { page, close } = await openDrawn(browser, report);
    await page.getByLabel('Colours', { exact: true }).selectOption(colouring);
    const perSecond = await page.evaluate(async () => {
      const slider = document.querySelector<HTMLInputElement>('.modes input[type=range]')!;
      const frame = () => new Promise((next) => requestAnimationFrame(next));
      let frames = 0;
      // The browser requests the next frame after it has shown the last one, so only visible frames are counted.
      const moveFor = async (milliseconds: number) => {
        const begun = performance.now();
        for (frames = 0; performance.now() - begun < milliseconds; ++frames) {
          slider.value = String(3 * Math.sin(frames / 10));
          slider.dispatchEvent(new Event('input'));
          await frame();
        }
        return (1000 * frames) / (performance.now() - begun);
      };
      await moveFor(1000);
      return moveFor(4000);
    });
    console.log(`coloured by ${colouring}: ${perSecond.toFixed(1)} slider movements a second`);
    expect(perSecond).toBeGreaterThanOrEqual(30);
    await close();
  },
  60_000,
);
