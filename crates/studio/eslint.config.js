import js from "@eslint/js";
import globals from "globals";

export default [
  { ignores: ["**/vendor.js", "dist/", "node_modules/"] },
  js.configs.recommended,
  {
    files: ["**/page/**/*.js"],
    languageOptions: { ecmaVersion: 2024, sourceType: "module", globals: { ...globals.browser } },
    rules: {
      eqeqeq: "error",
      "no-var": "error",
      "prefer-const": "error",
      "no-restricted-properties": ["error", { property: "innerHTML", message: "Use a template, or picture() for a drawing of the engine." }],
      "max-len": ["error", { code: 140, ignoreStrings: true, ignoreTemplateLiterals: true }],
    },
  },
  { files: ["**/worker.js", "**/service_worker.js"], languageOptions: { globals: { ...globals.worker, ...globals.serviceworker } } },
  { files: ["tests/page/**/*.js", "vendor/*.js"], languageOptions: { globals: { ...globals.node } } },
];
