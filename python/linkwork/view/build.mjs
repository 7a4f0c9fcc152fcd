// Builds bundle/ from src/ and the packages that package-lock.json pins: npm ci && npm run build
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

// What the bundle is made of, in this order; the test computes the same.
const sources = ["build.mjs", "package-lock.json", "package.json", ...readdirSync("src").sort().map((name) => `src/${name}`)];
const hash = createHash("sha256");
for (const name of sources) hash.update(`${name}\0`).update(readFileSync(name)).update("\0");

mkdirSync("bundle", { recursive: true });
await build({
  entryPoints: { viewer: "src/main.js" },
  outdir: "bundle",
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
});
const licenses = ["three", "uplot"].map((name) => {
  const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`));
  return `${name} ${version}\n\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim()}\n`;
});
const intro = "viewer.js and viewer.css contain parts of these packages:\n";
writeFileSync("bundle/LICENSES.txt", [intro, ...licenses].join("\n"));
const digests = ["viewer.js", "viewer.css", "LICENSES.txt"].map((name) => [name, digest(readFileSync(`bundle/${name}`))]);
writeFileSync("bundle/built.json", `${JSON.stringify({ sources: hash.digest("hex"), ...Object.fromEntries(digests) }, null, 2)}\n`);

function digest(content) {
  return createHash("sha256").update(content).digest("hex");
}
