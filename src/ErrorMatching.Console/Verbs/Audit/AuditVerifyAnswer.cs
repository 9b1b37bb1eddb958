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
    }

    public override void WriteText(Page page)
    {
        page.Line(finding.Message);
        page.Line($"The last one's hash is {finding.Hash}.");
        if (finding.Contents > 0)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture, $"{finding.Contents} contents with {finding.ContentBytes} bytes have their hashes."));
        }

        if (finding.Pages > 0)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture, $"{finding.Pages} pages are not stored: each is checked when it is drawn from its report."));
        }
    }
}
