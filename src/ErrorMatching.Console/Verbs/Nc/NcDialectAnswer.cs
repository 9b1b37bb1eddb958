using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>One dialect as a manual page.</summary>
internal sealed class NcDialectAnswer(NcDialect dialect) : NcDialectsAnswer([dialect])
{
    private const int WidestSubject = 30;
    private const int WidestMeaning = 60;

    private static readonly (DialectTopic Topic, string Heading, string Subject)[] Sections =
    [
        (DialectTopic.Setting, "Settings", "setting"),
        (DialectTopic.Code, "Codes and words", "code"),
        (DialectTopic.Letter, "Letters and addresses", "letter"),
        (DialectTopic.Function, "M functions", "function"),
        (DialectTopic.Flow, "Words that branch, loop or define programs", "word"),
        (DialectTopic.MachineProgram, "Programs that are in the machine", "program"),
        (DialectTopic.Refusal, "What the control refuses in a block", "name"),
        (DialectTopic.Note, "What else is assumed", "topic"),
    ];

    private readonly NcDialect _dialect = dialect;

    public override void WriteText(Page page)
    {
        page.Heading($"{_dialect.Name}: {_dialect.Description}");
        foreach (var (topic, heading, subject) in Sections)
        {
            var rows = _dialect.Facts.Where(f => f.Topic == topic).ToArray();
            if (rows.Length == 0)
            {
                continue;
            }

            page.Line();
            page.Heading(heading);
            page.Line();
            if (rows.All(f => f.Meaning.Length == 0))
            {
                page.Table(
                    [subject, "statement", "source", "stated by"], rows.SelectMany(f => Rows(f.Subject, f.Statement, f.Source, f.Dialect)));
            }
            else
            {
                page.Table(
                    [subject, "means", "statement", "source", "stated by"],
                    rows.SelectMany(f => Rows(f.Subject, f.Meaning, f.Statement, f.Source, f.Dialect)));
            }
        }
    }

    // A long list of codes continues in rows of its own, so that it does not push the sentences off the screen.
    private static IEnumerable<IReadOnlyList<string>> Rows(string subject, params IReadOnlyList<string> cells)
    {
        var (subjects, first) = (Lines(subject, WidestSubject), Lines(cells[0], cells.Count > 3 ? WidestMeaning : int.MaxValue));
        for (var i = 0; i < Math.Max(subjects.Count, first.Count); i++)
        {
            yield return [
                subjects.ElementAtOrDefault(i) ?? "", first.ElementAtOrDefault(i) ?? "", .. cells.Skip(1).Select(c => i == 0 ? c : "")];
        }
    }

    private static List<string> Lines(string text, int widest)
    {
        var lines = new List<string> { "" };
        foreach (var word in text.Split(' '))
        {
            if (lines[^1].Length > 0 && lines[^1].Length + 1 + word.Length > widest)
            {
                lines.Add("");
            }

            lines[^1] += (lines[^1].Length == 0 ? "" : " ") + word;
        }

        return lines;
    }
}
