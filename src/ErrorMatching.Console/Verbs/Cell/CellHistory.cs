using System.CommandLine;
using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell history</c>.</summary>
internal sealed class CellHistory : CellVerb
{
    // Not taken from the enumeration: building the command line must not load the cell's library. A test checks that they agree.
    internal static readonly string[] States =
    [
        "archived", "recognized", "computed", "proposed", "approved", "uploading", "verified", "released", "superseded", "recorded",
        "refused", "rejected", "failed", "reverted",
    ];

    private readonly Option<string> _serial = new("--serial") { Description = "Serial number of the piece.", HelpName = "SERIAL" };
    private readonly Option<string> _workOrder = new("--work-order") { Description = "Work order.", HelpName = "ORDER" };
    private readonly Option<string> _from = new("--from")
    {
        Description = "Arrived at this time (UTC, such as 2026-11-21 or 2026-11-21T22:00) or later.",
        HelpName = "TIME"
    };
    private readonly Option<string> _to = new("--to") { Description = "Arrived before this time.", HelpName = "TIME" };
    private readonly Option<string> _program = new("--program")
    {
        Description = "Name of the program at the machine, or the first 8 or more digits of its SHA-256.",
        HelpName = "PROGRAM"
    };
    private readonly Option<string> _user = new("--user") { Description = "Who took any of its steps.", HelpName = "NAME" };
    private readonly Option<string> _state = new("--state")
    {
        Description = "How far it has come: " + string.Join(", ", States) + ".",
        HelpName = "STATE"
    };
    private readonly Option<int> _most = new("--most")
    {
        Description = "How many of the latest are listed.",
        HelpName = "N",
        DefaultValueFactory = _ => 50
    };

    public CellHistory()
        : base("history", "Searches what arrived and what became of it.", "errormatch cell history samples/cell/cell.json --state released")
    {
        Options.Add(_serial);
        Options.Add(_workOrder);
        Options.Add(_from);
        Options.Add(_to);
        Options.Add(_program);
        Options.Add(_user);
        _state.CompletionSources.Add(States);
        Options.Add(_state);
        Options.Add(_most);
        Demand(_from, t => Time(t) is not null, "a time such as 2026-11-21 or 2026-11-21T22:00, in UTC");
        Demand(_to, t => Time(t) is not null, "a time such as 2026-11-21 or 2026-11-21T22:00, in UTC");
        Demand(_state, States.Contains, "one of " + string.Join(", ", States));
        _most.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<int>() is < 1 or > 100_000)
            {
                result.AddError("--most is out of range; expected 1 to 100000.");
            }
        });
    }

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithStoreToRead(settings, store =>
        {
            var query = Query(arguments);
            var found = store.Search(query);
            return new CellHistoryAnswer(found, found.Count < query.Most ? found.Count : store.Count(query));
        });

    private HistoryQuery Query(ParseResult arguments) => new()
    {
        Serial = arguments.GetValue(_serial),
        WorkOrder = arguments.GetValue(_workOrder),
        From = Time(arguments.GetValue(_from)),
        To = Time(arguments.GetValue(_to)),
        Program = arguments.GetValue(_program),
        User = arguments.GetValue(_user),
        State = State(arguments.GetValue(_state)),
        Most = arguments.GetValue(_most),
    };

    private static DateTimeOffset? Time(string? text) =>
        DateTimeOffset.TryParse(
            text, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal | DateTimeStyles.AdjustToUniversal, out var time)
            ? time
            : null;

    private static CorrectionState? State(string? word) => word is null ? null : (CorrectionState)Array.IndexOf(States, word);
}
