// What is handed out: the solver as an npm package, build/npm/snug-VERSION.tgz, and the page's static files as an archive,
// build/npm/snug-page-VERSION.tar.gz. After `npm run build`.
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync } from "node:fs";
import { fileURLToPath } from "node:url";

const file = (path) => fileURLToPath(new URL(path, import.meta.url));

export function pack(into = file("../build/npm")) {
    const { version } = JSON.parse(readFileSync(file("../bindings/wasm/package.json"), "utf8"));
    const known = /SNUG_VERSION "([^"]+)"/.exec(readFileSync(file("../include/snug/version.hpp"), "utf8"))[1];
    if (version !== known) throw new Error(`bindings/wasm/package.json is of version ${version}, the library of ${known}`);
    const stage = `${into}/package`;
    rmSync(stage, { recursive: true, force: true });
    mkdirSync(stage, { recursive: true });
    const solver = process.env.SNUG_WASM ?? file("../build/wasm");
    for (const name of ["snug.mjs", "snug.wasm"]) copyFileSync(`${solver}/${name}`, `${stage}/${name}`);
    for (const name of ["package.json", "README.md", "snug.d.ts"]) copyFileSync(file(`../bindings/wasm/${name}`), `${stage}/${name}`);
    copyFileSync(file("../LICENSE"), `${stage}/LICENSE`);
    execFileSync("npm", ["pack", "--silent", "--pack-destination", into], { cwd: stage, stdio: "ignore" });
    const page = `${into}/snug-page-${version}.tar.gz`;
    execFileSync("tar", ["-czf", page, "-C", file("dist"), "."]);
    return { tarball: `${into}/snug-${version}.tgz`, page };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) console.log(Object.values(pack()).join("\n"));
