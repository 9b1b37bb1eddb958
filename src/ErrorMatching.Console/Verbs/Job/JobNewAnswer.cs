using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>A job or configuration that was written.</summary>
/// <param name="file">The file.</param>
/// <param name="check">The words of the verb that checks it.</param>
internal sealed class JobNewAnswer(string file, string check) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/job-new/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json) => json.WriteString("file", file);

    /// <inheritdoc/>
    public override void WriteText(Page page)
    {
        page.Line($"Wrote {file}. Name your files in it and what belongs to them, then: errormatch {check} {file}");
    }
}
