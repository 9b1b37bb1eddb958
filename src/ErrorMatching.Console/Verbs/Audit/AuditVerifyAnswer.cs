using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>An intact audit trail.</summary>
internal sealed class AuditVerifyAnswer(AuditFinding finding) : DocumentAnswer
{
    public override string Schema => "errormatch/audit-verify/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteBoolean("holds", finding.Holds);
        json.WriteNumber("entries", finding.Entries);
        json.WriteString("hash", finding.Hash);
        json.WriteBoolean("isSealChecked", finding.IsSealChecked);
        json.WriteString("message", finding.Message);
        json.WriteNumber("contents", finding.Contents);
        json.WriteNumber("contentBytes", finding.ContentBytes);
        json.WriteNumber("pages", finding.Pages);
        json.WriteStartArray("archives");
        foreach (var archive in finding.Archives)
        {
            json.WriteStartObject();
            json.WriteString("name", archive.Name);
            json.WriteBoolean("isThere", archive.IsThere);
            json.WriteNumber("contents", archive.Contents);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        // Green only where everything was read: the seal as well as every archive.
        page.Verdict(finding.Message, finding.IsSealChecked && finding.Archives.All(a => a.IsThere) ? true : null);
        page.Line($"The last one's hash is {finding.Hash}.");
        if (finding.Contents > 0)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture, $"{finding.Contents} contents with {finding.ContentBytes} bytes have their hashes."));
        }

        if (finding.Archives.Where(a => a.IsThere).Sum(a => a.Contents) is > 0 and var moved)
        {
            page.Line(string.Create(CultureInfo.InvariantCulture, $"{moved} contents in archives have their hashes."));
        }

        if (finding.Pages > 0)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture, $"{finding.Pages} pages are not stored: each is checked when it is drawn from its report."));
        }
    }
}
