using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Measurement.Tests;

/// <summary>The rules of AQDEF (ISO/TR 11462-5) for a file with description and values of one piece.</summary>
internal static partial class AqdefRules
{
    private static readonly Dictionary<int, int> MostCharacters = new()
    {
        [1001] = 30,
        [1002] = 80,
        [1053] = 30,
        [2001] = 20,
        [2002] = 80,
        [2142] = 20,
    };

    /// <summary>What is wrong with a file; empty if it is valid.</summary>
    public static IReadOnlyList<string> Check(string text)
    {
        var problems = new List<string>();
        var lines = text.Split('\n');
        if (lines[^1].Length > 0 || text.Contains('\r', StringComparison.Ordinal))
        {
            problems.Add("Lines end otherwise than with a line feed.");
        }

        var fields = lines[..^2].Select(l => Field().Match(l)).ToArray();
        if (fields.Any(f => !f.Success) || fields[0].Value is not ['K', '0', '1', '0', '0', ..])
        {
            return [.. problems, "The description has a line that is no field, or does not begin with K0100."];
        }

        var count = Number(fields[0], "value");
        var numbers = fields.Select(f => Number(f, "number")).ToArray();
        if (Array.FindLastIndex(numbers, n => n < 2000) > Array.FindIndex(numbers, n => n >= 2000))
        {
            problems.Add("A field of the part is behind one of a characteristic.");
        }

        problems.AddRange(fields
            .Where(f => MostCharacters.TryGetValue(Number(f, "number"), out var most) && f.Groups["value"].Length > most)
            .Select(f => $"{f.Value} is too long."));
        foreach (var field in fields.Where(f => Number(f, "number") is 2101 or 2110 or 2111))
        {
            if (!double.TryParse(field.Groups["value"].Value, NumberStyles.Float, CultureInfo.InvariantCulture, out _))
            {
                problems.Add($"{field.Value} is no number.");
            }
        }

        for (var i = 1; i <= count; i++)
        {
            var own = fields.Where(f => f.Groups["index"].Value == i.ToString(CultureInfo.InvariantCulture))
                .ToDictionary(f => Number(f, "number"), f => f.Groups["value"].Value);
            if (!own.ContainsKey(2001) || !own.ContainsKey(2002) || !own.ContainsKey(2142))
            {
                problems.Add($"Characteristic {i} lacks number, name or unit.");
            }

            if (own.TryGetValue(2110, out var lower) && own.TryGetValue(2111, out var upper)
                && double.Parse(lower, CultureInfo.InvariantCulture) > double.Parse(upper, CultureInfo.InvariantCulture))
            {
                problems.Add($"The limits of characteristic {i} are reversed.");
            }
        }

        if (fields.Any(f => f.Groups["index"].Success && Number(f, "index") is var index && (index < 1 || index > count)))
        {
            problems.Add("A field belongs to no characteristic.");
        }

        var values = lines[^2].Split('\u000f');
        if (values.Length != count || values.Any(v => !Value().IsMatch(v)))
        {
            problems.Add("The values are not one for each characteristic.");
        }

        return problems;
    }

    private static int Number(Match field, string group) => int.Parse(field.Groups[group].Value, CultureInfo.InvariantCulture);

    [GeneratedRegex("^K(?<number>[0-9]{4})(/(?<index>[0-9]+))? (?<value>[^\u0000-\u001f]+)$", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Field();

    [GeneratedRegex("^-?[0-9]+(\\.[0-9]{1,6})?\u00140$", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Value();
}
