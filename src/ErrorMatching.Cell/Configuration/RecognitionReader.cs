using System.Text.RegularExpressions;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Reads the patterns that recognize a job's files.</summary>
internal sealed class RecognitionReader(JsonItem item, CellProblems problems)
{
    public const string Serial = "serial";
    public const string WorkOrder = "workOrder";
    public const string ToolChanged = "toolChanged";

    /// <summary>True if a pattern captures the serial number.</summary>
    public bool HasSerial { get; private set; }

    public RecognitionSettings Read()
    {
        if (item.Members.Count == 0)
        {
            problems.Refuse(
                item,
                "recognition-missing",
                "no pattern",
                "at least one of \"fileName\", \"headerField\" and \"column\": else every file would be this job's");
        }

        return new(item.Find("fileName") is { } name ? Pattern(name) : null, Named("headerField"), Named("column"));
    }

    /// <summary>The regular expression of a pattern. Its time grows with the length of the text, regardless of content.</summary>
    /// <exception cref="ArgumentException">The pattern is not a regular expression.</exception>
    /// <exception cref="NotSupportedException">The pattern uses lookarounds or backreferences.</exception>
    public static Regex Expression(string pattern) =>
        new(pattern, RegexOptions.NonBacktracking | RegexOptions.CultureInvariant, Regex.InfiniteMatchTimeout);

    private (string Name, string Pattern)? Named(string key) =>
        item.Find(key) is { } named ? (named["name"].Text, Pattern(named["pattern"])) : null;

    private string Pattern(JsonItem pattern)
    {
        try
        {
            var groups = Expression(pattern.Text).GetGroupNames().Where(n => !char.IsAsciiDigit(n[0])).ToArray();
            HasSerial |= groups.Contains(Serial);
            foreach (var group in groups.Where(g => g is not (Serial or WorkOrder or ToolChanged)))
            {
                problems.Refuse(
                    pattern,
                    "unknown-group",
                    $"the group \"{group}\"",
                    $"{Serial}, {WorkOrder} or {ToolChanged}, or a group without a name: (...)");
            }
        }
        catch (Exception e) when (e is ArgumentException or NotSupportedException)
        {
            problems.Refuse(
                pattern,
                "bad-pattern",
                $"the pattern \"{pattern.Text}\"",
                "a regular expression without look-around and back references: " + e.Message.TrimEnd('.'));
        }

        return pattern.Text;
    }
}
