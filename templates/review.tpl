{{%AUTOESCAPE context="HTML"}}
<div id="review" class="review" role="region" aria-labelledby="review-title" hidden>
<h3 id="review-title">Review the loops and candidates</h3>
</div>
