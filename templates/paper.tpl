{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>The paper, regenerated and checked</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the results</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · the paper, regenerated</p>
<h1>Viscous friction measurement technique in robot joint with the use of surrogate mass</h1>
<p class="subtitle">Every figure, table and equation of the paper in the order printed, each recomputed and compared with what is printed.</p>
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Outcome</a></li>
<li><a href="#tick-off">Checklist</a></li>
{{#CONTENTS_ENTRY}}<li class="stage"><a href="#{{SECTION_ID}}">{{NUMBER}} {{TITLE}}</a></li>
{{/CONTENTS_ENTRY}}
<li><a href="#errata">Errata of the paper</a></li>
<li><a href="#scenario">The joint that is simulated</a></li>
<li><a href="#provenance">Provenance</a></li>
</ol>
</nav>
<main id="content">
{{>VERDICT}}
<section id="tick-off" aria-labelledby="tick-off-title">
<h2 id="tick-off-title">Checklist <a class="self" href="#tick-off" aria-label="Link to this section">#</a></h2>
{{>TALLY}}
{{#KIND}}<h3>{{KIND_NAME}}</h3>
<ul class="ticks">
{{#ENTRY}}<li class="{{STATE}}"><a href="#{{ITEM_ID}}" title="{{TITLE}}">{{NUMBER}} <span aria-hidden="true">{{TICK}}</span><span class="spoken">{{SPOKEN}}</span></a></li>
{{/ENTRY}}</ul>
{{/KIND}}
<details class="fold" id="how-to-read"><summary>How to read the checks</summary>
<p>A check of kind <b>print</b> compares what the paper prints, a number, a sign or an order, with what is computed for its joint: these alone show that the paper is reproduced, and each printed number is counted once. A check of kind <b>independent</b> compares the program with another way to the same: the equation written out, a closed form, another solver, a balance of the log. What is so by definition, or was taken from print, is told below the checks and counted with neither. “Allowed” is the largest difference that counts as agreement; it follows from the digits printed or from the cause that is stated.</p>
<p>The paper prints no parameter of its joint. What is simulated here is a joint whose six torques agree with table 2; which numbers are printed, reconstructed or chosen is stated <a href="#scenario">at the end</a>. Whether the checks of print can fail is shown by <code>tribolog paper --wrong-joints</code>.</p>
</details>
</section>
{{#PAPER_SECTION}}<section id="{{SECTION_ID}}" class="stage" aria-labelledby="{{SECTION_ID}}-title">
<h2 id="{{SECTION_ID}}-title"><span class="number">{{NUMBER}}</span> {{TITLE}} <a class="self" href="#{{SECTION_ID}}" aria-label="Link to this section">#</a></h2>
{{>ITEM}}
{{#SELECTION}}<details class="folded"><summary>Curves, masses, errors and choice on this joint</summary>
{{>TABLE}}
</details>{{/SELECTION}}
</section>
{{/PAPER_SECTION}}
<details class="folded"><summary>Errata of the paper</summary>
{{>ERRATA}}
</details>
<details class="folded"><summary>The joint that is simulated</summary>
<section id="scenario" class="stage" aria-labelledby="scenario-title">
<h2 id="scenario-title">The joint that is simulated <a class="self" href="#scenario" aria-label="Link to this section">#</a></h2>
<p>The two files that this page is computed from, as built into the program and found in <code>examples/paper</code>.</p>
{{#SOURCE_FILE}}<details><summary><code>{{FILE_NAME}}</code></summary>
<pre class="command">{{FILE_TEXT}}</pre>
</details>
{{/SOURCE_FILE}}
</section>
</details>
<details class="folded"><summary>Provenance</summary>
{{>PROVENANCE}}
</details>
<p class="on-paper">Checks that hold, further tables, the errata and the simulated joint are folded in the file, and are not printed unless they are unfolded first.</p>
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · all checks as JSON are embedded in this file, in the element <code>tribolog-paper</code></p></footer>
<script type="application/json" id="tribolog-paper">{{RESULT_JSON:x-json}}</script>
</body>
</html>
