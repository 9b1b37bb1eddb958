namespace ErrorMatching.Reporting;

/// <summary>The frame of a report: one file without network access or scripts.</summary>
public static class ReportPage
{
    private static readonly Lazy<string> Css = new(ReadCss);

    /// <summary>Writes a page about a job: its heading begins with the job's name, and its work order, if it has one, is below.</summary>
    /// <param name="job">The job.</param>
    /// <param name="subject">What the page is about.</param>
    /// <param name="sections">Its sections, listed at the top.</param>
    /// <param name="lead">Writes what comes before everything else; null for nothing.</param>
    public static byte[] Write(ReportJob job, string subject, IReadOnlyList<PageSection> sections, Action<HtmlText>? lead = null)
    {
        ArgumentNullException.ThrowIfNull(job);
        return Write($"{job.Name}: {subject}", job.WorkOrder is { } order ? $"Work order {order}" : null, sections, lead);
    }

    /// <summary>Writes a page.</summary>
    /// <param name="title">Its heading and window title.</param>
    /// <param name="subtitle">The subject, below the heading; null for none.</param>
    /// <param name="sections">Its sections, listed at the top.</param>
    /// <param name="lead">Writes what comes before everything else; null for nothing.</param>
    public static byte[] Write(string title, string? subtitle, IReadOnlyList<PageSection> sections, Action<HtmlText>? lead = null)
    {
        var html = new HtmlText();
        using (html.In("html", ("lang", "en")))
        {
            WriteHead(html, title);
            using (html.In("body"))
            {
                html.Put("a", $"Skip to: {sections[0].Title}", ("class", "skip"), ("href", "#" + sections[0].Id));
                using (html.In("header"))
                {
                    lead?.Invoke(html);
                    html.Put("h1", title);
                    if (subtitle is not null)
                    {
                        html.Put("p", subtitle, ("class", "subtitle"));
                    }

                    WriteContents(html, sections);
                }

                using (html.In("main"))
                {
                    foreach (var section in sections)
                    {
                        WriteSection(html, section);
                    }
                }
            }
        }

        return html.ToBytes();
    }

    private static void WriteHead(HtmlText html, string title)
    {
        using (html.In("head"))
        {
            html.Empty("meta", ("charset", "utf-8"));
            html.Empty("meta", ("name", "viewport"), ("content", "width=device-width, initial-scale=1"));

            // If anything slips through the escaping, the browser still neither runs nor fetches it.
            html.Empty("meta", ("http-equiv", "Content-Security-Policy"), ("content", "default-src 'none'; style-src 'unsafe-inline'"));
            html.Put("title", title);
            html.Style(Css.Value);
        }
    }

    private static void WriteContents(HtmlText html, IReadOnlyList<PageSection> sections)
    {
        using (html.In("nav", ("aria-label", "Contents")))
        using (html.In("ul"))
        {
            foreach (var section in sections)
            {
                using (html.In("li"))
                {
                    html.Put("a", section.Title, ("href", "#" + section.Id));
                }
            }
        }
    }

    private static void WriteSection(HtmlText html, PageSection section)
    {
        using (html.In("section", ("id", section.Id), ("aria-labelledby", section.Id + "-title")))
        {
            html.Put("h2", section.Title, ("id", section.Id + "-title"));
            section.Write(html);
        }
    }

    private static string ReadCss()
    {
        using var stream = typeof(ReportPage).Assembly.GetManifestResourceStream("report.css")!;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }
}
