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
    }

    public override void WriteText(Page page)
    {
        page.Line(finding.Message);
        page.Line($"The last one's hash is {finding.Hash}.");
    }
}
