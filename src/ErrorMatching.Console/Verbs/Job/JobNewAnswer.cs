using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>A new job or configuration.</summary>
/// <param name="file">The file.</param>
/// <param name="check">The verb that checks it.</param>
internal sealed class JobNewAnswer(string file, string check) : DocumentAnswer
{
    public override string Schema => "errormatch/job-new/1";

    public override void WriteJson(Utf8JsonWriter json) => json.WriteString("file", file);

    public override void WriteText(Page page)
    {
        page.Line($"Wrote {file}. Name your files in it and what belongs to them, then: errormatch {check} {file}");
    }
}
