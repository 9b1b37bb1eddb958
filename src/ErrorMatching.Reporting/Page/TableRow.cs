namespace ErrorMatching.Reporting;

/// <summary>Writes the cells of a row.</summary>
public sealed class TableRow(HtmlText html)
{
    /// <summary>Writes the cell that names the row.</summary>
    public void Header(string text) => html.Put("th", text, ("scope", "row"));

    /// <summary>Writes a cell with text.</summary>
    public void Text(string text) => html.Put("td", text);

    /// <summary>Writes a number, aligned at its decimal point.</summary>
    public void Number(string text) => html.Put("td", text, ("class", "num"));

    /// <summary>Writes program text or a file name, character by character.</summary>
    public void Code(string text)
    {
        using (html.In("td"))
        {
            html.Put("code", text);
        }
    }

    /// <summary>Opens a cell with markup.</summary>
    public HtmlScope Cell(string? cssClass = null) => html.In("td", ("class", cssClass));
}
