namespace ErrorMatching.Reporting;

/// <summary>An open element that is closed at the end of the scope.</summary>
public readonly ref struct HtmlScope(HtmlText html, string element)
{
    /// <summary>Ends the element.</summary>
    public void Dispose() => html.End(element);
}
