// node validate.mjs FOLDER: every .glb there must pass the Khronos glTF validator without an error, and without
// a warning that explained.json does not explain. An explanation that its files do not need any more fails too.
// gltf-validator is looked up from where this file lies, see ../../scripts/validator.sh.
import { readFileSync, readdirSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import validator from 'gltf-validator';

const severities = ['error', 'warning'];
const here = dirname(fileURLToPath(import.meta.url));
const explained = JSON.parse(readFileSync(join(here, 'explained.json')));
const needed = new Set();

function explains(explanation, file, message) {
  const fits = explanation.code === message.code && new RegExp(explanation.file).test(file);
  if (fits) needed.add(explanation);
  return fits;
}

/// Errors and warnings of a file, those that are explained counted only.
async function findings(file) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file, format: 'glb', maxIssues: 0, writeTimestamp: false,
  });
  const serious = report.issues.messages.filter((message) => message.severity < severities.length);
  const name = basename(file);
  const open = serious.filter(
    (message) => message.severity === 0 || !explained.some((explanation) => explains(explanation, name, message)));
  return { open, explained: serious.length - open.length };
}

const folder = process.argv[2];
const files = readdirSync(folder).filter((name) => name.endsWith('.glb')).sort();
let failures = 0;
let accepted = 0;
for (const name of files) {
  const result = await findings(join(folder, name));
  accepted += result.explained;
  failures += result.open.length;
  const shown = 10;
  for (const message of result.open.slice(0, shown))
    console.error(`${name}: ${severities[message.severity]}: ${message.code} at ${message.pointer ?? message.offset}: ${message.message}`);
  if (result.open.length > shown) console.error(`${name}: ... and ${result.open.length - shown} more`);
}
const stale = (one) => !needed.has(one) && files.some((name) => new RegExp(one.file).test(name));
for (const explanation of explained.filter(stale)) {
  ++failures;
  console.error(`explained.json: ${explanation.file} has no ${explanation.code} any more`);
}
if (files.length === 0) {
  ++failures;
  console.error(`${folder}: no .glb`);
}
console.log(`${files.length} files, validator ${validator.version()}: ${failures} findings, ${accepted} explained warnings`);
process.exitCode = failures === 0 ? 0 : 1;
