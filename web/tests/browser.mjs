// The built page in Debian's Chromium, watched: an error on the console or a request to anywhere else fails the test.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { preview } from "vite";

export const root = fileURLToPath(new URL("..", import.meta.url));
export const command = process.env.SNUG_COMMAND ?? fileURLToPath(new URL("../../build/release/snug", import.meta.url));

/** What `snug` prints as JSON; it exits with 1 where the car cannot park. */
export function native(...words) {
    try {
        return JSON.parse(execFileSync(command, [...words.map(String), "--format", "json"], { encoding: "utf8", stdio: "pipe" }));
    } catch (error) {
        if (error.status === 1 || error.status === 3) return JSON.parse(error.stdout);
        throw error;
    }
}

let launched = null;
/** One for all that is tested: it takes longer to start than a page. */
const browser = () =>
    (launched ??= chromium.launch({
        executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
        args: ["--no-sandbox", "--disable-dev-shm-usage"],
    }));
export const closeBrowser = async () => (await launched)?.close();

/** The page of this folder, or whatever is built in the `dist` of another. */
export async function open({ root: of = root } = {}) {
    assert.ok(existsSync(command), `${command} is missing: build the command first`);
    const server = await preview({ root: of, configFile: false, logLevel: "error", preview: { port: 0, host: "127.0.0.1" }, base: "./" });
    const address = `http://127.0.0.1:${server.httpServer.address().port}/`;
    const troubles = [];
    const contexts = [];
    return {
        address,
        troubles,
        async page({ path = "", ready = true, ...options } = {}) {
            const context = await (await browser()).newContext({ viewport: { width: 1400, height: 900 }, acceptDownloads: true, ...options });
            contexts.push(context);
            const page = await context.newPage();
            page.setDefaultTimeout(60_000);
            page.on("console", (message) => message.type() === "error" && troubles.push(`console: ${message.text()}`));
            page.on("pageerror", (error) => troubles.push(`page: ${error.stack || `${error.name}: ${error.message}`}`));
            page.on("request", (request) => {
                if (!/^(http:\/\/127\.0\.0\.1|data:|blob:)/.test(request.url())) troubles.push(`request to ${request.url()}`);
            });
            await page.goto(address + path);
            if (ready) await page.waitForFunction(() => document.documentElement.dataset.ready);
            return page;
        },
        async closePages() {
            for (const context of contexts.splice(0)) await context.close();
        },
        async close() {
            await this.closePages();
            await new Promise((closed) => server.httpServer.close(closed));
        },
    };
}

/** Numbers between 0 and 1 from a seed (Mulberry32). */
export function random(seed) {
    return () => {
        seed = (seed + 0x6d2b79f5) | 0;
        let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
        t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
        return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
}

/** Where two answers differ. */
export function differences(a, b, where = "") {
    if (a === null || b === null || typeof a !== "object" || typeof b !== "object")
        return a === b ? [] : [`${where}: ${JSON.stringify(a)} and ${JSON.stringify(b)}`];
    const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
    return [...keys].flatMap((key) => differences(a[key], b[key], `${where}.${key}`));
}
