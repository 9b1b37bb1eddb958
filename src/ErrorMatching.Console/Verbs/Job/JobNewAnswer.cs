using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>A job that was written.</summary>
internal sealed class JobNewAnswer(string file) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/job-new/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json) => json.WriteString("file", file);

    /// <inheritdoc/>
    public override void WriteText(Page page)
    {
        page.Line($"Wrote {file}. Name your files in it and what belongs to them, then: errormatch job check {file}");
    }
}
