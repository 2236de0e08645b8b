// What is handed out works where it is unpacked: the npm package, installed from its tarball into a project of somebody
// else's, and the page's files served by any server.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { build } from "vite";
import { pack } from "../pack.mjs";
import { differences, native, open, root } from "./browser.mjs";

const folder = mkdtempSync(join(tmpdir(), "snug-package-"));
after(() => rmSync(folder, { recursive: true }));
const { tarball, page: archive } = pack(folder);

test("the npm package, installed from its tarball, has its types and answers as the command", { timeout: 300_000 }, async () => {
    const project = join(folder, "project");
    mkdirSync(project);
    writeFileSync(join(project, "package.json"), JSON.stringify({ name: "project", private: true, type: "module" }));
    execFileSync("npm", ["install", "--offline", "--no-audit", "--no-fund", tarball], { cwd: project, stdio: "pipe" });
    for (const name of ["snug.mjs", "snug.wasm", "snug.d.ts", "README.md", "LICENSE", "package.json"])
        assert.ok(existsSync(join(project, "node_modules/snug", name)), `${name} is not in the package`);
    // The types, strictly; a wrong question is no program.
    writeFileSync(
        join(project, "main.ts"),
        `import load, { type EntryAnswer } from "snug";
const snug = await load();
const answer: EntryAnswer = snug.entry("renault-zoe", { length: 4.5, width: 2 });
// @ts-expect-error a slot has a width
const wrong = () => snug.shortfall("renault-zoe", { length: 4.5 });
Object.assign(window, { answer, wrong, done: true });
`,
    );
    const options = { target: "ES2022", module: "ESNext", moduleResolution: "bundler", lib: ["ES2022", "DOM"], types: [], strict: true, noEmit: true };
    writeFileSync(join(project, "tsconfig.json"), JSON.stringify({ compilerOptions: options, include: ["main.ts"] }));
    execFileSync(join(root, "node_modules/.bin/tsc"), ["-p", project], { stdio: "pipe" });
    writeFileSync(join(project, "index.html"), '<!doctype html><html lang="en"><title>project</title><link rel="icon" href="data:," /><script type="module" src="./main.ts"></script></html>');
    await build({ root: project, configFile: false, logLevel: "error", base: "./", build: { target: "es2022" } });
    const site = await open({ root: project });
    const page = await site.page({ ready: false });
    await page.waitForFunction(() => window.done);
    const found = await page.evaluate(() => window.answer);
    const { any_maneuver, start_tolerance, ...expected } = native("entry", "--car", "renault-zoe", "--length", 4.5, "--width", 2);
    assert.deepEqual(differences(found, expected), []);
    assert.deepEqual(site.troubles, []);
    await site.close();
});

test("the page's archive, unpacked, is the page", { timeout: 120_000 }, async () => {
    const place = join(folder, "page");
    mkdirSync(join(place, "dist"), { recursive: true });
    execFileSync("tar", ["-xzf", archive, "-C", join(place, "dist")]);
    const site = await open({ root: place });
    const page = await site.page({ path: "#mode=entry&length=4.5&width=2" });
    assert.equal(await page.locator("#count").textContent(), "18");
    assert.deepEqual(site.troubles, []);
    await site.close();
});
