namespace ErrorMatching.Reporting;

/// <summary>Writes the section about the input files of a report and its reproduction.</summary>
public static class ReportInputs
{
    /// <summary>The digits of a hash that a person compares.</summary>
    public static string ShortHash(string sha256) => sha256.Length > 12 ? sha256[..12] : sha256;

    /// <summary>The file of a role; null if there is none.</summary>
    public static ReportInput? Find(IReadOnlyList<ReportInput> inputs, string role) => inputs.FirstOrDefault(i => i.Role == role);

    /// <summary>Writes files and hashes, and the command that reproduces the report.</summary>
    /// <param name="html">The output.</param>
    /// <param name="job">The job.</param>
    /// <param name="inputs">Its files.</param>
    /// <param name="verb">The console's verb.</param>
    /// <param name="options">Options of the verb with the roles of their files.</param>
    public static void Write(
        HtmlText html,
        ReportJob job,
        IReadOnlyList<ReportInput> inputs,
        string verb,
        params ReadOnlySpan<(string Option, string Role)> options)
    {
        HtmlTable.Write(
            html,
            "inputs-table",
            "Files that this report was made from",
            [new("What"), new("File"), new("SHA-256")],
            inputs.Prepend(new("job", job.File, job.Sha256)),
            (row, input) =>
        {
            row.Header(input.Role);
            row.Code(input.File);
            row.Code(input.Sha256);
        });
        html.Put("p", "The same files make the same result, on any machine. To make it again:");
        var command = $"errormatch {verb} {Quoted(job.File)}";
        foreach (var (option, role) in options)
        {
            command += Find(inputs, role) is { } input ? $" {option} {Quoted(input.File)}" : "";
        }

        using (html.In("p", ("class", "command")))
        {
            html.Put("code", command);
        }
    }

    private static string Quoted(string file) =>
        file.All(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '/' or '\\' or '-' or '_' or ':') ? file : $"\"{file}\"";
}
