using System.CommandLine;
using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell thin</c>.</summary>
internal sealed partial class CellThin : CellVerb
{
    private const int MostAge = 36_500;
    private const string Expected = "an age such as 2y, 18m, 730d or P2Y, of at least a day";

    private readonly Option<string> _olderThan = new("--older-than")
    {
        Description = "Corrections whose last step is older than this may lose their contents: years, months or days.",
        HelpName = "AGE",
        Required = true,
    };
    private readonly Option<int> _keepLast = new("--keep-last")
    {
        Description = "The latest corrections of each slot keep theirs, however old they are.",
        HelpName = "N",
        DefaultValueFactory = _ => 100,
    };
    private readonly Option<bool> _dryRun = new("--dry-run")
    {
        Description = "Only say how much would be moved.",
        Arity = ArgumentArity.Zero
    };

    public CellThin()
        : base(
            "thin",
            "Moves measurements, programs and reports of old corrections from the store to an archive, while the cell goes on. History and "
                + "audit verify read them there.",
            "errormatch cell thin samples/cell/cell.json --older-than 2y --dry-run")
    {
        Options.Add(_olderThan);
        Options.Add(_keepLast);
        Options.Add(_dryRun);
        Demand(_olderThan, t => Before(t, DateTimeOffset.UnixEpoch.AddYears(MostAge / 365)) is not null, Expected);
        _keepLast.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<int>() is < 1 or > 1_000_000)
            {
                result.AddError("--keep-last is out of range; expected 1 to 1000000.");
            }
        });
    }

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithExistingStore(settings, store =>
    {
        var isRehearsed = arguments.GetValue(_dryRun);
        var policy = new ThinPolicy(
            Before(arguments.GetRequiredValue(_olderThan), TimeProvider.System.GetUtcNow())!.Value, arguments.GetValue(_keepLast));
        using var progress = new CellProgressLine(ProgressTo);
        var thinned = store.Thin(
            policy, isRehearsed ? null : SystemUser.Name(Environment.GetEnvironmentVariable), progress, cancellation);
        return new CellThinAnswer(policy, thinned, isRehearsed, settings.Store.ArchiveFolder);
    });

    // Null if it is no age.
    private static DateTimeOffset? Before(string text, DateTimeOffset now)
    {
        if (Age().Match(text) is not { Success: true } age) return null;
        var number = int.Parse(age.Groups["number"].ValueSpan, NumberStyles.None, CultureInfo.InvariantCulture);
        var unit = char.ToLowerInvariant(age.Groups["unit"].ValueSpan[0]);
        var days = unit switch { 'y' => 365, 'm' => 30, _ => 1 };
        return number < 1 || number > MostAge / days ? null : unit switch
        {
            'y' => now.AddYears(-number),
            'm' => now.AddMonths(-number),
            _ => now.AddDays(-number),
        };
    }

    [GeneratedRegex("^P?(?<number>[0-9]{1,5})(?<unit>[YyMmDd])$", RegexOptions.CultureInvariant, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Age();
}
