using System.Text.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The dialects and what they state about their controls.</summary>
internal sealed class NcDialectsAnswer : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/nc-dialects/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteStartArray("dialects");
        foreach (var dialect in NcDialects.All)
        {
            json.WriteStartObject();
            json.WriteString("name", dialect.Name);
            json.WriteString("description", dialect.Description);
            json.WriteStartArray("facts");
            foreach (var fact in dialect.Facts)
            {
                json.WriteStartObject();
                json.WriteString("topic", fact.Topic);
                json.WriteString("statement", fact.Statement);
                json.WriteString("source", fact.Source);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    /// <inheritdoc/>
    public override void WriteText(Page page)
    {
        foreach (var dialect in NcDialects.All)
        {
            page.Heading($"{dialect.Name}: {dialect.Description}");
            page.Table(["topic", "statement", "source"], dialect.Facts.Select(f => (IReadOnlyList<string>)[f.Topic, f.Statement, f.Source]));
            page.Line();
        }
    }
}
