// The page shows the same numbers as the program computes.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { launch, openDrawn, settle, type OpenPage } from '../support/browser';
import { foramen, largestDifference, models, pointsOfPly } from '../support/foramen';

const { folder: work, model, baseline } = models();
let browser: Browser, opened: OpenPage, page: Page;

beforeAll(async () => {
  browser = await launch();
  opened = await openDrawn(browser, join(model, 'report.html'));
  page = opened.page;
});
afterAll(async () => {
  await browser?.close();
});

async function saved(): Promise<Buffer> {
  await settle(page);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save this shape as PLY' }).click(),
  ]);
  return readFileSync(await download.path());
}

async function setSlider(mode: number, score: number): Promise<void> {
  await page.getByRole('slider', { name: `Score of mode ${mode},` }).fill(String(score));
}

const modeFile = (folder: string, mode: number, sign: string) => join(folder, `mode0${mode}_${sign}2sd.ply`);

it('moves the landmarks to where `foramen modes` puts them, for every mode', async () => {
  const folder = join(work, 'modes');
  await foramen('modes', model, '--sd', '2', '-o', folder);
  const modes = readdirSync(folder).length / 2;
  expect(await page.getByRole('slider', { name: /^Score of mode \d+,/ }).count()).toBe(modes);
  for (let mode = 1; mode <= modes; ++mode)
    for (const [sign, score] of [
      ['minus', -2],
      ['plus', 2],
    ] as const) {
      await setSlider(mode, score);
      expect(largestDifference(pointsOfPly(await saved()), pointsOfPly(modeFile(folder, mode, sign)))).toBeLessThan(
        1e-4,
      );
      await setSlider(mode, 0);
    }
});

it('adds up the sliders of all modes', async () => {
  const folder = join(work, 'modes');
  const [mean, first, second] = [join(model, 'mean.ply'), modeFile(folder, 1, 'plus'), modeFile(folder, 2, 'plus')].map(
    pointsOfPly,
  );
  await setSlider(1, 1);
  await setSlider(2, -3);
  const expected = mean.map((x, i) => x + 0.5 * (first[i] - x) - 1.5 * (second[i] - x));
  expect(largestDifference(pointsOfPly(await saved()), expected)).toBeLessThan(2e-4);
  await page.getByRole('button', { name: 'Reset to the mean' }).click();
  expect(largestDifference(pointsOfPly(await saved()), mean)).toBeLessThan(1e-5);
});

it('saves the triangles that the program writes', async () => {
  await page.getByRole('button', { name: 'Reset to the mean' }).click();
  const ours = await saved(),
    theirs = readFileSync(join(model, 'mean.ply'));
  const facesOf = (bytes: Buffer) => {
    const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
    return bytes.subarray(end + 4 * pointsOfPly(bytes).length).toString('hex');
  };
  expect(ours.subarray(0, 100).toString()).toContain('comment SPACE=LPS');
  expect(facesOf(ours)).toBe(facesOf(theirs));
});

// Distances between points of a shape, which do not depend on its pose.
function distances(points: Float32Array): number[] {
  const count = points.length / 3;
  return Array.from({ length: 500 }, (_, i) => {
    const a = 3 * ((i * 7919) % count),
      b = 3 * ((i * 104729 + 13) % count);
    return Math.hypot(points[a] - points[b], points[a + 1] - points[b + 1], points[a + 2] - points[b + 2]);
  });
}

it('shows each training shape as it is', async () => {
  await page.getByRole('tab', { name: 'Training shapes' }).click();
  for (const file of readdirSync(join(model, 'corresponding'))) {
    await page.getByLabel('Training shape', { exact: true }).selectOption({ label: file.replace('.ply', '') });
    const shown = distances(pointsOfPly(await saved())),
      true_ = distances(pointsOfPly(join(model, 'corresponding', file)));
    expect(Math.max(...shown.map((d, i) => Math.abs(d - true_[i])))).toBeLessThan(1e-3);
  }
});

it('says how far the fit is off, down to nothing with all modes', async () => {
  const fit = page.getByRole('slider', { name: 'Modes of the fit beside it' });
  await fit.fill('0');
  await expect.poll(() => page.locator('.status').textContent()).toMatch(/by (?!0\.0)\d+\.\d\d mm \(root/);
  await fit.fill((await fit.getAttribute('max'))!);
  await expect.poll(() => page.locator('.status').textContent()).toContain('by 0.00 mm');
});

it('names what was left out and why, the baseline, the inputs and the papers', async () => {
  const text = (await page.locator('main').textContent())!;
  for (const part of [
    'broken',
    'ply',
    'baseline: closest',
    'this model',
    'synth001.ply',
    'Becker',
    'Davies',
    'not for diagnosis',
  ])
    expect(text).toContain(part);
});

it('marks the flipped triangles of the baseline’s shapes, as many as were counted', async () => {
  const { names, representation } = JSON.parse(readFileSync(join(baseline, 'metrics.json'), 'utf8'));
  const counts: number[] = representation.shapes.map((s: { plain_flips: number }) => s.plain_flips);
  const worst = counts.indexOf(Math.max(...counts));
  expect(counts[worst]).toBeGreaterThan(0);
  const other = await openDrawn(browser, join(baseline, 'report.html'));
  await other.page.getByRole('button', { name: names[worst], exact: true }).click();
  await expect.poll(() => other.page.locator('.legend').textContent()).toContain(`${counts[worst]} flipped triangle`);
  await settle(other.page);
  const torus = () => other.page.locator('.torus').screenshot();
  const marked = await torus();
  await other.page.getByLabel('Flipped triangles').uncheck();
  await settle(other.page);
  expect(marked.equals(await torus())).toBe(false);
  expect(other.complaints).toEqual([]);
  await other.close();
});

it('complained of nothing and asked for nothing', () => {
  expect(opened.complaints).toEqual([]);
});
