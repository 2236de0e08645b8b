// What the tests of the page share: the site, watched after each test, and how a person uses a page of it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, afterEach } from "node:test";
import { closeBrowser, open, root } from "./browser.mjs";

export const site = await open();
afterEach(async () => {
    await site.closePages();
    assert.deepEqual(site.troubles.splice(0), [], "errors on the console or requests to elsewhere");
});
after(async () => {
    await site.close();
    await closeBrowser();
});

export const text = (page, id) => page.locator(`#${id}`).textContent();
export const inputs = (page) => page.evaluate(() => window.snugPage.inputs());
export const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
export const choose = async (page, name, value) => {
    await page.locator(`input[name=${name}][value=${value}]`).check({ force: true });
    await settled(page);
};
export const type = async (page, field, value) => {
    await page.locator(`#${field}`).fill(value);
    await settled(page);
};
/** Another link on a page that is open already. */
export const follow = async (page, hash) => {
    await page.evaluate(
        (to) =>
            new Promise((done) => {
                const before = location.href;
                window.addEventListener("hashchange", () => done(), { once: true });
                location.hash = to;
                if (location.href === before) done(); // the same, perhaps written otherwise: nothing happens
            }),
        hash,
    );
    await settled(page);
};

/** Where a handle of a picture is held. */
export const middle = async (page, picture, grip) => {
    await page.evaluate(() => scrollTo(0, 0));
    const { x, y, width, height } = await page.locator(`#${picture} [data-grip="${grip}"] ${grip === "car" ? ".reach" : ".knob"}`).boundingBox();
    return [x + width / 2, y + height / 2];
};
/** By mouse; `by`: where it goes from there, step by step. */
export const dragged = async (page, picture, grip, ...by) => {
    const [x, y] = await middle(page, picture, grip);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (const [dx, dy] of by) await page.mouse.move(x + dx, y + dy);
    await settled(page);
    await page.mouse.up();
    await settled(page);
};
/** By finger. */
export const touched = async (page, picture, grip, ...by) => {
    const client = await page.context().newCDPSession(page);
    const [x, y] = await middle(page, picture, grip);
    const touch = (kind, touchPoints) => client.send("Input.dispatchTouchEvent", { type: kind, touchPoints });
    await touch("touchStart", [{ x, y }]);
    for (const [dx, dy] of by) await touch("touchMove", [{ x: x + dx, y: y + dy }]);
    await touch("touchEnd", []);
    await settled(page);
};
/** What the keyboard reaches one after another, until `last`. */
export const reachedByTab = async (page, last) => {
    const reached = new Set();
    for (let i = 0; i < 70 && !reached.has(last); ++i) {
        await page.keyboard.press("Tab");
        reached.add(await page.evaluate(() => {
            const at = document.activeElement;
            return at.id || at.dataset.grip || at.name || at.className || at.localName;
        }));
    }
    return reached;
};

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
/** What axe finds wrong. In the dark only colours differ. */
export const violations = async (page, colorScheme) => {
    await page.addScriptTag({ content: axe });
    return page.evaluate(
        async (only) => (await window.axe.run(only)).violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target).join(", ")}`),
        colorScheme === "dark" ? { runOnly: { type: "rule", values: ["color-contrast"] } } : {},
    );
};

export const screenshot = (page, name, options = {}) =>
    page.screenshot({ path: join(process.env.SNUG_SCREENSHOTS ?? join(root, "../build/web"), `${name}.png`), ...options });
