namespace ErrorMatching.Reporting;

/// <summary>Writes lists of names and values, warnings and notes.</summary>
public static class ReportFacts
{
    /// <summary>Writes a list of facts.</summary>
    public static void Write(HtmlText html, params ReadOnlySpan<(string Name, string Value)> facts)
    {
        using (html.In("dl"))
        {
            foreach (var (name, value) in facts)
            {
                using (html.In("div"))
                {
                    html.Put("dt", name);
                    html.Put("dd", value);
                }
            }
        }
    }

    /// <summary>Writes warnings; nothing if there are none.</summary>
    public static void WriteWarnings(HtmlText html, IReadOnlyList<string> warnings) => WriteList(html, "⚠ Warning", "warning", warnings);

    /// <summary>Writes notes; nothing if there are none.</summary>
    public static void WriteNotes(HtmlText html, IReadOnlyList<string> notes) => WriteList(html, "Note", "note", notes);

    private static void WriteList(HtmlText html, string word, string cssClass, IReadOnlyList<string> sentences)
    {
        if (sentences.Count == 0)
        {
            return;
        }

        using (html.In("div", ("class", "box " + cssClass)))
        {
            html.Put("h3", sentences.Count == 1 ? word : word + "s");
            using (html.In("ul"))
            {
                foreach (var sentence in sentences)
                {
                    html.Put("li", sentence);
                }
            }
        }
    }
}
