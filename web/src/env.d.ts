declare module "snug.wasm?url" {
    const url: string;
    export default url;
}
declare module "snug.mjs?url" {
    const url: string;
    export default url;
}
