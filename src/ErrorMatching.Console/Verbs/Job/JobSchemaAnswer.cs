using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>The JSON Schema of a kind of job. As a document of the console it has an additional key for that, which validators
/// ignore.</summary>
internal sealed class JobSchemaAnswer(string text) : DocumentAnswer
{
    public override string Schema => "errormatch/job-schema/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        using var schema = JsonDocument.Parse(text);
        foreach (var member in schema.RootElement.EnumerateObject())
        {
            member.WriteTo(json);
        }
    }

    public override void WriteText(Page page) => page.Line(text.TrimEnd('\n'));
}
