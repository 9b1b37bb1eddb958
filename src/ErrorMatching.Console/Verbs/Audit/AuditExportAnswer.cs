using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>An audit trail as CSV.</summary>
/// <param name="csv">All of it.</param>
/// <param name="entries">How many entries it has.</param>
/// <param name="file">Where it was written to; null for standard output.</param>
internal sealed class AuditExportAnswer(string csv, long entries, string? file) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/audit-export/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteNumber("entries", entries);
        json.WriteString("sha256", Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(csv))));
        if (file is null)
        {
            json.WriteString("csv", csv);
        }
    }

    /// <inheritdoc/>
    public override void WriteText(Page page)
    {
        if (file is null)
        {
            page.Text(csv);
            return;
        }

        page.Line(string.Create(CultureInfo.InvariantCulture, $"Wrote {entries} entries to {file}."));
    }
}
