// node check.mjs FOLDER: opens FOLDER/index.html, the page of studies, with Debian's Chromium in a broad and a narrow
// window, with scripts and without, and fails with a line for everything that is wrong. Pictures of the page go to
// FOLDER. Then it damages the page in each way that it looks for, and fails if it does not find one.
// playwright-core is looked up from where this file lies, see ../../scripts/report.sh.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { damages } from './damages.mjs';
import { findings, open_windows } from './findings.mjs';

const widths = [1280, 400];
const folder = resolve(process.argv[2]);
const page = join(folder, 'index.html');

const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
let failures = 0;
const fail = (sentence) => {
  ++failures;
  console.error(sentence);
};

const windows = {};
for (const width of widths) {
  windows[width] = await open_windows(browser, width);
  const found = await findings(windows[width], pathToFileURL(page).href, join(folder, `page-${width}.png`));
  const most = 20;
  found.slice(0, most).forEach(fail);
  if (found.length > most) fail(`... and ${found.length - most} more`);
}

/// The page with its first study that has a plot and a picture alone, which is enough to be damaged.
function shortened(html) {
  const studies = html.match(/<section .*?<\/section>/gs) ?? [];
  const kept = studies.find((study) => study.includes('class="plot"') && study.includes('<img '));
  return html.replace(/<main>.*<\/main>/s, () => `<main>${kept}</main>`);
}

const workshop = mkdtempSync(join(tmpdir(), 'rambla-report-'));
try {
  const right = shortened(readFileSync(page, 'utf8'));
  for (const [index, { width, finding, damage }] of damages.entries()) {
    const file = join(workshop, `damage-${index}.html`);
    writeFileSync(file, damage(right));
    const found = await findings(windows[width], pathToFileURL(file).href);
    if (!found.some((sentence) => finding.test(sentence))) fail(`the check does not see its damage: ${finding}`);
  }
} finally {
  rmSync(workshop, { recursive: true });
  await browser.close();
}

console.log(`${page}: ${failures} findings in windows of ${widths.join(' and ')} px; ${damages.length} damages tried`);
process.exitCode = failures === 0 ? 0 : 1;
