{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Experiment plan: {{TITLE}}</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the plan</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · experiment plan</p>
<h1><bdi>{{TITLE}}</bdi></h1>
<p class="subtitle">What to do, what it will give, and how reliably.</p>
{{#FACTS}}<dl class="identity">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Outcome</a></li>
<li><a href="#experiment">The experiment</a></li>
{{#HOW}}<li><a href="#how">How to run it</a></li>{{/HOW}}
{{#EXPECTATION}}<li><a href="#expected">What to expect</a></li>{{/EXPECTATION}}
<li><a href="#assumptions">Assumptions</a></li>
<li><a href="#made">How this was made</a></li>
</ol>
</nav>
<main id="content">
{{>VERDICT}}
<section id="experiment" aria-labelledby="experiment-title">
<h2 id="experiment-title">The experiment <a class="self" href="#experiment" aria-label="Link to this section">#</a></h2>
{{>PARTS}}
</section>
{{#HOW}}<section id="how" aria-labelledby="how-title">
<h2 id="how-title">How to run it <a class="self" href="#how" aria-label="Link to this section">#</a></h2>
<ul>
{{#INSTRUCTION}}<li><bdi>{{TEXT}}</bdi></li>
{{/INSTRUCTION}}</ul>
<details class="fold"><summary>Recordings and their time windows</summary>
{{>POSITIONS}}
{{>WINDOWS}}
</details>
</section>{{/HOW}}
{{#EXPECTATION}}<section id="expected" aria-labelledby="expected-title">
<h2 id="expected-title">What to expect <a class="self" href="#expected" aria-label="Link to this section">#</a></h2>
{{>EXPECTED}}
</section>{{/EXPECTATION}}
{{#OVERVIEW}}<section id="course" aria-label="The plan over time">
{{>FIGURE}}
</section>{{/OVERVIEW}}
{{#DETAILS}}<details class="folded"><summary>Further figures</summary>
{{>FIGURE}}
</details>{{/DETAILS}}
<details class="folded"><summary>Assumptions</summary>
<section id="assumptions" aria-labelledby="assumptions-title">
<h2 id="assumptions-title">Assumptions <a class="self" href="#assumptions" aria-label="Link to this section">#</a></h2>
<p>What is not stated is assumed. State what is known in the joint's file: amplitudes, speeds and expected intervals follow from it.</p>
{{>ASSUMPTIONS}}
</section>
</details>
<details class="folded"><summary>How this was made</summary>
<section id="made" aria-labelledby="made-title">
<h2 id="made-title">How this was made <a class="self" href="#made" aria-label="Link to this section">#</a></h2>
<details><summary>The joint, <code><bdi>{{JOINT_FILE}}</bdi></code></summary>
<pre class="command"><bdi>{{JOINT_TEXT}}</bdi></pre>
</details>
<p>The same file, seed and program give the same plan again. Made {{CREATED:x-dates}} with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
</section>
</details>
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · all numbers as JSON are embedded in this file, in the element <code>tribolog-plan</code></p></footer>
<script type="application/json" id="tribolog-plan">{{RESULT_JSON:x-json}}</script>
</body>
</html>
