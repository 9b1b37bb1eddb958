using System.Text.RegularExpressions;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>What patterns have captured about a piece.</summary>
internal sealed class FoundWords
{
    private const int Most = 100;

    public string? Serial { get; private set; }

    public string? WorkOrder { get; private set; }

    /// <summary>True if a pattern found the word for a changed tool.</summary>
    public bool ToolChanged { get; private set; }

    /// <summary>Values from two places that differ, or a value that is not usable as a serial number or work order; null if nothing is
    /// wrong.</summary>
    public Statement? Contradiction { get; private set; }

    /// <summary>Adds what a match captured.</summary>
    public void Add(Match match)
    {
        Serial = Joined(Serial, match.Groups[RecognitionReader.Serial], "serial number");
        ToolChanged |= match.Groups[RecognitionReader.ToolChanged].Length > 0;
        WorkOrder = Joined(WorkOrder, match.Groups[RecognitionReader.WorkOrder], "work order");
    }

    private string? Joined(string? before, Group group, string what)
    {
        if (!group.Success || group.Value == before)
        {
            return before;
        }

        if (group.Length is 0 or > Most || group.Value != ShownName.Of(group.Value))
        {
            Contradiction ??= Recorded.SaysNoName.With(what, Most);
        }
        else if (before is not null)
        {
            Contradiction ??= Recorded.SaysTwo.With(what, before, group.Value);
        }

        return before ?? group.Value;
    }
}
