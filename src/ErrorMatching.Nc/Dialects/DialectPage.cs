using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>Builds the rows of a dialect's manual page from its files. Omits a subject from an earlier row if a later file states it
/// again, and omits rows without subjects.</summary>
internal static class DialectPage
{
    public static IReadOnlyList<DialectFact> Of(IReadOnlyList<DialectDocument> documents)
    {
        var facts = new List<DialectFact>();
        AddNamed(facts, DialectTopic.Setting, documents, d => d.Root.Find("settings")?.Members.Select(m => (m.Name, m.Value)) ?? []);
        foreach (var (key, subjects, topic) in DialectDocument.Lists)
        {
            AddSubjects(facts, topic, documents, key, subjects);
        }

        AddNamed(facts, DialectTopic.Refusal, documents, d => d.List("refusals").Select(n => (n["name"].Text, n)));
        AddNamed(facts, DialectTopic.Note, documents, d => d.List("notes").Select(n => (n["topic"].Text, n)));
        return facts;
    }

    private static void AddNamed(
        List<DialectFact> facts,
        DialectTopic topic,
        IReadOnlyList<DialectDocument> documents,
        Func<DialectDocument, IEnumerable<(string Name, JsonItem Item)>> rowsOf)
    {
        var start = facts.Count;
        foreach (var document in documents)
        {
            foreach (var (name, item) in rowsOf(document))
            {
                var fact = Fact(topic, name, item, document);
                var before = facts.FindIndex(start, f => f.Subject == name);
                if (before >= 0)
                {
                    facts[before] = fact;
                }
                else
                {
                    facts.Add(fact);
                }
            }
        }
    }

    private static void AddSubjects(
        List<DialectFact> facts, DialectTopic topic, IReadOnlyList<DialectDocument> documents, string list, string key)
    {
        // Decides who owns a subject: the later file, and within a file the single subject over the range.
        var owners = new Dictionary<string, (int Row, int Subject)>(StringComparer.Ordinal);
        var rows = new List<(DialectDocument Document, JsonItem Entry, List<SubjectRange> Subjects)>();
        foreach (var document in documents)
        {
            var first = rows.Count;
            foreach (var entry in document.List(list))
            {
                var subjects = new List<SubjectRange>();
                SubjectRange.TryRead(entry[key].Text, topic, subjects, out _);
                rows.Add((document, entry, subjects));
            }

            foreach (var isRange in (bool[])[true, false])
            {
                for (var row = first; row < rows.Count; row++)
                {
                    for (var i = 0; i < rows[row].Subjects.Count; i++)
                    {
                        if (rows[row].Subjects[i].IsRange == isRange)
                        {
                            foreach (var name in rows[row].Subjects[i].Names())
                            {
                                owners[name] = (row, i);
                            }
                        }
                    }
                }
            }
        }

        var owning = owners.Values.ToHashSet();
        for (var row = 0; row < rows.Count; row++)
        {
            var (document, entry, subjects) = rows[row];
            var kept = subjects.Where((_, i) => owning.Contains((row, i))).Select(s => s.Spelling).ToArray();
            if (kept.Length > 0)
            {
                facts.Add(Fact(topic, string.Join(' ', kept), entry, document));
            }
        }
    }

    private static DialectFact Fact(DialectTopic topic, string subject, JsonItem item, DialectDocument document) =>
        new(topic, subject, topic == DialectTopic.Refusal ? RefusalText.Of(item) : MeaningOf(item), item["statement"].Text,
            item["source"].Text, document.Name);

    private static string MeaningOf(JsonItem item)
    {
        var meaning = (item.Find("means") ?? item.Find("role") ?? item.Find("value")) is { } value
            ? value.Kind == JsonItemKind.Text
            ? value.Text
            : value.ToJson()
            : "";
        var family = item.Find("family") is { } name ? $" ({name.Text})" : "";
        var offsets = item.Find("offsets") is { } names ? $" ({names.Text})" : "";
        return meaning + family + offsets + (item.Find("feeds") is { Flag: false } ? " (not feeds)" : "");
    }
}

/// <summary>One statement of a dialect about its control, with its source: a row of the manual page.</summary>
/// <param name="Topic">Its topic.</param>
/// <param name="Subject">Its subject, as in the dialect's file: codes, letters, the name of a setting.</param>
/// <param name="Meaning">Its meaning for the interpreter, as in the dialect's file (<c>work-offset</c>, <c>axis</c>, <c>true</c>); empty
/// if there is only the statement.</param>
/// <param name="Statement">The fact, in a sentence.</param>
/// <param name="Source">The manual or standard, a measurement, or the word <c>assumed</c>.</param>
/// <param name="Dialect">Name of the dialect whose file states it: the dialect itself, or one that it continues.</param>
public sealed record DialectFact(DialectTopic Topic, string Subject, string Meaning, string Statement, string Source, string Dialect);
