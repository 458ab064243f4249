// Using the page: keyboard, pointer, sizes of screens, colour schemes, printing, and no WebGL.
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, open, openDrawn, picture, screens, settle } from '../support/browser';
import { models } from '../support/foramen';

const report = join(models().model, 'report.html');
let browser: Browser;

beforeAll(async () => {
  browser = await launch();
});
afterAll(async () => {
  await browser?.close();
});

async function withPage(options: Parameters<typeof openDrawn>[2], use: (page: Page) => Promise<void>): Promise<void> {
  const opened = await openDrawn(browser, report, options);
  await use(opened.page);
  expect(opened.complaints).toEqual([]);
  await opened.close();
}

const look = (page: Page) => page.locator('.space').screenshot();

async function changes(page: Page, act: () => Promise<unknown>): Promise<boolean> {
  await settle(page);
  const before = await look(page);
  await act();
  await settle(page);
  return !before.equals(await look(page));
}

describe('by keyboard', () => {
  it('sliders move, numbers are typed, tabs turn, the eye goes round', () =>
    withPage(screens.wide, async (page) => {
      const slider = page.getByRole('slider', { name: 'Score of mode 1,' });
      const number = page.getByRole('spinbutton', { name: 'Score of mode 1,' });
      await slider.focus();
      expect(await changes(page, () => page.keyboard.press('ArrowRight'))).toBe(true);
      expect(await number.inputValue()).toBe('0.05');
      await number.fill('-1.5');
      await settle(page);
      expect(await slider.inputValue()).toBe('-1.5');
      await number.fill('7');
      await number.blur();
      expect(await slider.inputValue()).toBe('3');

      await page.getByRole('tab', { name: 'Modes' }).focus();
      await page.keyboard.press('ArrowRight');
      expect(await page.getByRole('tab', { name: 'Training shapes' }).getAttribute('aria-selected')).toBe('true');
      expect(await page.getByRole('tabpanel').getAttribute('id')).toBe('page-shapes');

      await page.locator('.space canvas').focus();
      for (const key of ['ArrowLeft', 'ArrowUp', '+', '-'])
        expect(await changes(page, () => page.keyboard.press(key))).toBe(true);
      await page.getByRole('spinbutton', { name: 'Landmark' }).fill('17');
      await settle(page);
      expect(await page.locator('.torus-mark').getAttribute('visibility')).toBe('visible');
    }));

  it('every control has a name and the focus is seen', () =>
    withPage(screens.wide, async (page) => {
      const nameless = await page.evaluate(() =>
        [...document.querySelectorAll<HTMLElement>('button, input, select, canvas, summary, a, [role=region]')]
          .filter(
            (e) => !(e.getAttribute('aria-label') || (e as HTMLInputElement).labels?.length || e.textContent?.trim()),
          )
          .map((e) => e.outerHTML),
      );
      expect(nameless).toEqual([]);
      await page.keyboard.press('Tab');
      const outline = await page.evaluate(() => getComputedStyle(document.activeElement!).outlineStyle);
      expect(outline).toBe('solid');
    }));
});

describe('by pointer', () => {
  it('the same landmark is marked on the surface and on the torus', () =>
    withPage(screens.wide, async (page) => {
      const stage = (await page.locator('.space').boundingBox())!,
        torus = (await page.locator('.torus').boundingBox())!;
      await page.getByRole('button', { name: 'Back' }).click();
      await page.waitForTimeout(600);
      const landmark = page.getByRole('spinbutton', { name: 'Landmark' });
      // The middle may be in the canal, so several points are tried until one hits the bone.
      let found: { x: number; y: number } | null = null;
      for (let i = 1; i < 10 && !found; ++i) {
        const at = { x: stage.x + stage.width * (0.3 + 0.04 * i), y: stage.y + stage.height * 0.5 };
        await page.mouse.move(at.x, at.y);
        await settle(page);
        if ((await landmark.inputValue()) !== '') found = at;
      }
      expect(found).not.toBeNull();
      await page.mouse.click(found!.x, found!.y);
      await page.mouse.move(5, 5);
      await settle(page);
      const pinned = await landmark.inputValue();
      expect(pinned).not.toBe('');
      // The nearest of 400 landmarks. Edges are about 60 pixels long here.
      const mark = (await page.locator('.mark').first().boundingBox())!;
      expect(Math.hypot(mark.x + mark.width / 2 - found!.x, mark.y + mark.height / 2 - found!.y)).toBeLessThan(60);

      // Pointing at its mark on the torus must select the same landmark.
      const spot = (await page.locator('.torus-mark').boundingBox())!;
      await page.mouse.move(torus.x + 3, torus.y + torus.height / 2);
      await page.mouse.move(spot.x + spot.width / 2, spot.y + spot.height / 2);
      await settle(page);
      expect(await landmark.inputValue()).toBe(pinned);
    }));

  it('dragging turns, the wheel scrolls the page until the model is clicked', () =>
    withPage(screens.wide, async (page) => {
      const stage = (await page.locator('.space').boundingBox())!;
      const middle = [stage.x + stage.width / 2, stage.y + stage.height / 2] as const;
      await page.mouse.move(...middle);
      expect(await changes(page, () => page.mouse.wheel(0, 60))).toBe(false);
      await page.evaluate(() => scrollTo(0, 0));
      expect(
        await changes(page, async () => {
          await page.mouse.move(...middle);
          await page.mouse.down();
          await page.mouse.move(middle[0] + 80, middle[1] + 20, { steps: 4 });
          await page.mouse.up();
        }),
      ).toBe(true);
      expect(await changes(page, () => page.mouse.wheel(0, -300))).toBe(true);
      expect(await page.evaluate(() => scrollY)).toBe(0);
    }));

  it('a mode plays until it is stopped', () =>
    withPage(screens.wide, async (page) => {
      const play = page.getByRole('button', { name: 'Play mode 2' }),
        slider = page.getByRole('slider', { name: 'Score of mode 2,' });
      await play.click();
      await expect.poll(() => slider.inputValue()).not.toBe('0');
      await play.click();
      const stopped = await slider.inputValue();
      await page.waitForTimeout(200);
      expect(await slider.inputValue()).toBe(stopped);
    }));

  it('colours and overlays change the picture', () =>
    withPage(screens.wide, async (page) => {
      const colours = page.getByLabel('Colours', { exact: true });
      for (const kind of ['displacement', 'torus', 'checkerboard', 'plain'])
        expect(await changes(page, () => colours.selectOption(kind)), kind).toBe(true);
      for (const name of ['Loops', 'Triangles'])
        expect(await changes(page, () => page.getByLabel(name, { exact: true }).check()), name).toBe(true);
    }));

  it('marks are drawn, each alone if it is chosen, and can be switched off', () =>
    withPage(screens.wide, async (page) => {
      const rim = page.getByRole('button', { name: /^rim/ }),
        tip = page.getByRole('button', { name: 'tip 0.00' });
      expect(await changes(page, () => tip.click())).toBe(true);
      expect(await changes(page, () => rim.click())).toBe(true);
      expect(await rim.getAttribute('aria-pressed')).toBe('true');
      expect(await tip.getAttribute('aria-pressed')).toBe('false');
      expect(await changes(page, () => page.getByLabel('Marks', { exact: true }).uncheck())).toBe(true);
      expect(await rim.isVisible()).toBe(false);
    }));
});

// Relative luminance and contrast as WCAG 2 define them.
const contrastInPage = () => {
  const probe = document.createElement('i');
  document.body.append(probe);
  const luminance = (name: string) => {
    probe.style.color = `var(${name})`;
    const channels = getComputedStyle(probe)
      .color.match(/[\d.]+/g)!
      .slice(0, 3)
      .map((c) => Number(c) / 255);
    const [r, g, b] = channels.map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const page = luminance('--page');
  return Object.fromEntries(
    ['--ink', '--muted', '--accent', '--series-1', '--warn'].map((name) => {
      const [low, high] = [page, luminance(name)].sort((a, b) => a - b);
      return [name, (high + 0.05) / (low + 0.05)];
    }),
  );
};

describe.each(['wide', 'phone'] as const)('on a %s screen', (screen) => {
  it.each(['light', 'dark'] as const)('in a %s scheme all is readable and nothing overflows', (colorScheme) =>
    withPage({ ...screens[screen], colorScheme }, async (page) => {
      for (const [name, contrast] of Object.entries(await page.evaluate(contrastInPage)))
        expect(contrast, name).toBeGreaterThan(4.5);
      const width = screens[screen].viewport.width;
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      const name = `${screen}_${colorScheme}`;
      await picture(page, `${name}_model`);
      await page.getByRole('slider', { name: 'Score of mode 1,' }).fill('2');
      await page.getByRole('tab', { name: 'Training shapes' }).click();
      await page.getByLabel('Loops').check();
      await settle(page);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      await page.evaluate(() => scrollTo(0, 0));
      await picture(page, `${name}_shapes`);
      for (const part of ['summary', 'quality', 'shapes', 'provenance']) {
        await page.locator(`#${part}`).evaluate((e) => e.scrollIntoView());
        await settle(page);
        await picture(page, `${name}_${part}`);
      }
    }),
  );
});

// The sizes are read in an observer that is created after those of the page. The browser calls it after them, so it
// sees what is shown.
const watchFrames = () => {
  const seen = { frames: 0, empty: 0 };
  Object.assign(window, { seen });
  const small = new OffscreenCanvas(60, 60).getContext('2d', { willReadFrequently: true })!;
  const watch = (canvas: HTMLCanvasElement) =>
    new ResizeObserver(() => {
      small.clearRect(0, 0, 60, 60);
      small.drawImage(canvas, 0, 0, 60, 60);
      ++seen.frames;
      if (small.getImageData(0, 0, 60, 60).data.every((value) => value === 0)) ++seen.empty;
    }).observe(canvas.parentElement!);
  document.querySelectorAll<HTMLCanvasElement>('.space canvas, .torus canvas').forEach(watch);
};

it('shows no empty frame while the window changes its size', () =>
  withPage(screens.wide, async (page) => {
    await settle(page);
    await page.evaluate(watchFrames);
    const seen = () => page.evaluate(() => (window as unknown as { seen: { frames: number; empty: number } }).seen);
    for (const width of [1300, 1000, 700, 1200]) {
      const { frames } = await seen();
      await page.setViewportSize({ width, height: 800 });
      // On a slow machine the two canvases may change one after the other, so the test waits for every size.
      await page.waitForFunction(
        (before) => (window as unknown as { seen: { frames: number } }).seen.frames > before,
        frames,
      );
      await settle(page);
    }
    expect((await seen()).empty).toBe(0);
  }));

it('prints what is folded away, and no controls', () =>
  withPage(screens.wide, async (page) => {
    await page.emulateMedia({ media: 'print' });
    expect(await page.getByRole('slider').first().isVisible()).toBe(false);
    expect(await page.locator('details:not([open])').count()).toBeGreaterThan(0);
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    expect(await page.locator('details:not([open])').count()).toBe(0);
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    expect(await page.locator('details[open]').count()).toBe(0);
  }));

it('has no control for marks if there are none', async () => {
  const { page, close } = await openDrawn(browser, join(models().baseline, 'report.html'));
  expect(await page.getByLabel('Loops', { exact: true }).isVisible()).toBe(true);
  expect(await page.getByText('Marks', { exact: true }).count()).toBe(0);
  await close();
});

it('without WebGL says so and shows all else', async () => {
  const plain = await launch(false);
  const { page } = await open(plain, report);
  await expect.poll(() => page.locator('#model').textContent()).toContain('no WebGL');
  expect(await page.locator('.chart svg').count()).toBeGreaterThan(4);
  expect(await page.locator('main').textContent()).toContain('synth001');
  await plain.close();
});
