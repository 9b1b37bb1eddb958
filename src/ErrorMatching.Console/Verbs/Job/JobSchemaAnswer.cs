using System.Text.Json;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary>The JSON Schema of mating jobs. As a document of the console it has one more key, which says so and which validators ignore.</summary>
internal sealed class JobSchemaAnswer : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/job-schema/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json)
    {
        using var schema = JsonDocument.Parse(JobTemplate.Schema);
        foreach (var member in schema.RootElement.EnumerateObject())
        {
            member.WriteTo(json);
        }
    }

    /// <inheritdoc/>
    public override void WriteText(Page page) => page.Line(JobTemplate.Schema.TrimEnd('\n'));
}
