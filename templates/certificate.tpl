{{%AUTOESCAPE context="HTML"}}
<section id="boundary" aria-labelledby="boundary-title">
<h3 id="boundary-title">What these numbers hold for</h3>
<dl class="terms">{{#BOUNDARY}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT}}</bdi></dd></div>
{{/BOUNDARY}}</dl>
</section>
<section id="certificate" aria-labelledby="certificate-title">
<h3 id="certificate-title">Certificate <bdi>{{REPORT_NUMBER}}</bdi></h3>
<dl class="terms">{{#STATED}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT}}</bdi></dd></div>
{{/STATED}}</dl>
<p class="signature"><span>Authorised by</span><span>Date, signature</span></p>
</section>
