// Pages with one thing wrong, made from one that is right: what the check finds in each shows that it can fail.

const before_end = (html, addition) => html.replace('</main>', () => `${addition}</main>`);
const style = (html, rules) => html.replace('</head>', () => `<style>${rules}</style></head>`);

export const damages = [
  { width: 1280, finding: /page error: damaged/, damage: (html) => before_end(html, '<script>throw Error("damaged")</script>') },
  { width: 1280, finding: /console: damaged/, damage: (html) => before_end(html, '<script>console.error("damaged")</script>') },
  { width: 1280, finding: /the page needs .*damage\.css/, damage: (html) => before_end(html, '<link rel="stylesheet" href="damage.css">') },
  { width: 1280, finding: /other content without scripts/,
    damage: (html) => before_end(html, '<p id="late"></p><script>document.getElementById("late").textContent = "late"</script>') },
  { width: 1280, finding: /no study/, damage: (html) => html.replaceAll('class="study"', 'class="damaged"') },
  { width: 1280, finding: /neither a table nor a plot/, damage: (html) => before_end(html, '<section class="study" id="empty"></section>') },
  { width: 1280, finding: /not in the contents/, damage: (html) => html.replaceAll('<li><a href="#', '<li><a href="#damaged-') },
  { width: 1280, finding: /no plot/, damage: (html) => html.replaceAll('class="plot"', 'class="damaged"') },
  { width: 1280, finding: /no mark/, damage: (html) => html.replaceAll('class="mark ', 'class="damaged ') },
  { width: 1280, finding: /a mark outside its axes/,
    damage: (html) => html.replace(/(class="mark [^>]*translate\()[\d.]+/, '$1439') },
  { width: 1280, finding: /no picture/, damage: (html) => html.replaceAll('<img ', '<span ') },
  { width: 1280, finding: /a broken picture/, damage: (html) => html.replace(/(;base64,.{40})[^"]*/, '$1') },
  { width: 1280, finding: /nothing stands for it/, damage: (html) => html.replace(/ alt="[^"]*"/, ' alt=""') },
  { width: 1280, finding: /a blurred picture/, damage: (html) => html.replace('class="pixels"', '') },
  { width: 1280, finding: /a picture out of shape/, damage: (html) => style(html, '.pictures img{height:99px}') },
  { width: 1280, finding: /a label on the picture/, damage: (html) => style(html, 'figcaption{position:relative;top:-2rem}') },
  { width: 400, finding: /a picture outside its column/, damage: (html) => style(html, '.pictures img{width:420px;max-width:none}') },
  { width: 400, finding: /the page is \d+ px wide/, damage: (html) => style(html, '.pictures img{width:420px;max-width:none}') },
  { width: 1280, finding: /a text outside the picture/, damage: (html) => html.replace(/(<text[^>]* x=")[\d.]+/, '$1435') },
  { width: 1280, finding: /a text that does not show/, damage: (html) => style(html, '.question,h2{display:none}') },
  { width: 1280, finding: /a text of \d\.\d px/, damage: (html) => style(html, 'nav{font-size:7px}') },
  { width: 400, finding: /a text of \d\.\d px/, damage: (html) => style(html, '.plot{max-width:240px}') },
  { width: 400, finding: /the page is \d+ px wide/, damage: (html) => style(html, '.scroll{overflow:visible}table{min-width:500px}') },
];
