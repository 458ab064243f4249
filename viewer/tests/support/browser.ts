import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium, type Browser, type BrowserContextOptions, type Page } from 'playwright-core';

// WebGL runs in software, as on every machine without graphics hardware.
const software = ['--no-sandbox', '--enable-unsafe-swiftshader'];
const noGraphics = ['--no-sandbox', '--disable-gpu', '--disable-software-rasterizer', '--disable-3d-apis'];

export function launch(graphics = true): Promise<Browser> {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: graphics ? software : noGraphics,
  });
}

export interface OpenPage {
  page: Page;
  /** Errors and warnings on the console, exceptions, and requests for anything but the file itself. */
  complaints: string[];
  close(): Promise<void>;
}

export const screens = {
  wide: { viewport: { width: 1440, height: 900 } },
  phone: { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true },
} satisfies Record<string, BrowserContextOptions>;

export async function open(
  browser: Browser,
  file: string,
  options: BrowserContextOptions = screens.wide,
): Promise<OpenPage> {
  const context = await browser.newContext({ acceptDownloads: true, ...options });
  const page = await context.newPage();
  const complaints: string[] = [];
  const address = pathToFileURL(file).href;
  page.on('console', (message) => {
    // The warnings of the software renderer about reading pixels are not errors of the page.
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall due to ReadPixels'))
      complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (request.url().split('#')[0] !== address && !/^(data|blob):/.test(request.url()))
      complaints.push(`request for ${request.url()}`);
  });
  await page.goto(address);
  return { page, complaints, close: () => context.close() };
}

export async function openDrawn(browser: Browser, file: string, options?: BrowserContextOptions): Promise<OpenPage> {
  const opened = await open(browser, file, options);
  await opened.page.waitForSelector('html[data-drawn]', { state: 'attached' });
  return opened;
}

/** Waits until everything has been drawn and no longer changes. */
export async function settle(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.waitForSelector('html[data-drawn=sharp]', { state: 'attached' });
}

/** Saves a screenshot in the folder FORAMEN_SCREENSHOTS, if it is set. */
export async function picture(page: Page, name: string): Promise<void> {
  const folder = process.env.FORAMEN_SCREENSHOTS;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}
