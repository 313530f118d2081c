// What is wrong with a page of studies as Chromium shows it. See check.mjs.

const smallest_text_px = 10;
const tolerance_px = 1;

/// Runs inside the page: everything that its layout tells, as sentences.
function layout_findings({ smallest_text_px, tolerance_px }) {
  const findings = [];
  const shown = (element) => element.textContent.trim().replace(/\s+/g, ' ').slice(0, 50);
  const inside = (inner, outer, margin_x, margin_y) =>
    inner.left >= outer.left - margin_x && inner.right <= outer.right + margin_x &&
    inner.top >= outer.top - margin_y && inner.bottom <= outer.bottom + margin_y;

  const width = document.scrollingElement.scrollWidth;
  if (width > window.innerWidth) findings.push(`the page is ${width} px wide in ${window.innerWidth} px`);

  const studies = [...document.querySelectorAll('section.study')];
  if (studies.length === 0) findings.push('no study');
  for (const study of studies) {
    if (!study.querySelector('table, svg.plot')) findings.push(`${study.id}: neither a table nor a plot`);
    if (!document.querySelector(`nav a[href="#${study.id}"]`)) findings.push(`${study.id}: not in the contents`);
  }

  const plots = [...document.querySelectorAll('svg.plot')];
  if (plots.length === 0) findings.push('no plot');
  for (const plot of plots) {
    const name = plot.getAttribute('aria-label');
    const frame = plot.querySelector('.frame').getBoundingClientRect();
    const marks = [...plot.querySelectorAll('.mark')];
    if (marks.length === 0) findings.push(`${name}: no mark`);
    for (const mark of marks) {
      const box = mark.getBoundingClientRect();
      // A mark at the end of an axis reaches over it by its radius.
      if (!inside(box, frame, tolerance_px + box.width / 2, tolerance_px + box.height / 2))
        findings.push(`${name}: a mark outside its axes, ${shown(mark)}`);
    }
    const picture = plot.getBoundingClientRect();
    for (const text of plot.querySelectorAll('text')) {
      if (!inside(text.getBoundingClientRect(), picture, tolerance_px, tolerance_px))
        findings.push(`${name}: a text outside the picture, ${shown(text)}`);
    }
  }

  const pictures = [...document.querySelectorAll('main img')];
  if (pictures.length === 0) findings.push('no picture');
  for (const picture of pictures) {
    const name = picture.alt || `a picture of ${picture.closest('section.study')?.id}`;
    if (!picture.alt) findings.push(`${name}: nothing stands for it where it cannot be seen`);
    if (!picture.complete || picture.naturalWidth === 0) {
      findings.push(`${name}: a broken picture`);
      continue;
    }
    const box = picture.getBoundingClientRect();
    const column = picture.closest('figure').getBoundingClientRect();
    if (!inside(box, column, tolerance_px, tolerance_px)) findings.push(`${name}: a picture outside its column`);
    const height = box.width * picture.naturalHeight / picture.naturalWidth;
    if (box.width === 0 || Math.abs(box.height - height) > tolerance_px)
      findings.push(`${name}: a picture out of shape, ${box.width.toFixed(0)} × ${box.height.toFixed(0)} px`);
    const pixels = getComputedStyle(picture).imageRendering === 'pixelated';
    if (box.width > picture.naturalWidth + tolerance_px && !pixels) findings.push(`${name}: a blurred picture`);
    const caption = picture.closest('figure').querySelector('figcaption').getBoundingClientRect();
    if (caption.top < box.bottom - tolerance_px) findings.push(`${name}: a label on the picture`);
  }

  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const parent = texts.currentNode.parentElement;
    if (!texts.currentNode.data.trim() || parent.closest('title, style, script')) continue;
    const range = document.createRange();
    range.selectNodeContents(texts.currentNode);
    const heights = [...range.getClientRects()].map((box) => box.height);
    if (heights.length === 0) findings.push(`a text that does not show, ${shown(parent)}`);
    else if (Math.min(...heights) < smallest_text_px)
      findings.push(`a text of ${Math.min(...heights).toFixed(1)} px, ${shown(parent)}`);
  }
  return findings;
}

/// What is folded has to be as right as the rest.
function unfold() {
  for (const folded of document.querySelectorAll('details')) folded.open = true;
}

/// The text and the numbers of marks and pictures that a reader finds.
function content() {
  const shown = [...document.images].filter((picture) => picture.naturalWidth > 0);
  return { text: document.body.innerText, marks: document.querySelectorAll('svg.plot .mark').length,
           pictures: shown.length };
}

/// Two windows of a width, one of which runs no scripts.
export async function open_windows(browser, width) {
  const viewport = { width, height: 900 };
  return { width, page: await browser.newPage({ viewport }),
           plain: await browser.newPage({ viewport, javaScriptEnabled: false }) };
}

/// Opens an HTML file and looks at it.
/// @param windows     from open_windows()
/// @param screenshot  where a picture of it goes; optional
/// @return            sentences, none for a page that is right
export async function findings({ width, page, plain }, url, screenshot) {
  const found = [];
  const listeners = {
    console: (message) => message.type() === 'error' && found.push(`console: ${message.text()}`),
    pageerror: (error) => found.push(`page error: ${error.message}`),
    request: (request) => request.url() === url || request.url().startsWith('data:') ||
      found.push(`the page needs ${request.url()}`),
  };
  for (const [event, listener] of Object.entries(listeners)) page.on(event, listener);
  await page.goto(url);
  if (screenshot) await page.screenshot({ path: screenshot, fullPage: true });
  await page.evaluate(unfold);
  found.push(...await page.evaluate(layout_findings, { smallest_text_px, tolerance_px }));
  const with_scripts = await page.evaluate(content);
  for (const [event, listener] of Object.entries(listeners)) page.off(event, listener);

  await plain.goto(url);
  await plain.evaluate(unfold);
  const without_scripts = await plain.evaluate(content);
  if (JSON.stringify(without_scripts) !== JSON.stringify(with_scripts))
    found.push('the page has other content without scripts');
  return found.map((finding) => `${width} px: ${finding}`);
}
