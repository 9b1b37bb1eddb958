using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>The JSON Schema of a kind of jobs. As a document of the console it has one more key, which says so and which validators ignore.</summary>
internal sealed class JobSchemaAnswer(string text) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/job-schema/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json)
    {
        using var schema = JsonDocument.Parse(text);
        foreach (var member in schema.RootElement.EnumerateObject())
        {
            member.WriteTo(json);
        }
    }

    /// <inheritdoc/>
    public override void WriteText(Page page) => page.Line(text.TrimEnd('\n'));
}
