using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell alarms</c>.</summary>
internal sealed class CellAlarms : SigningVerb
{
    private readonly Option<string> _acknowledge = new("--acknowledge")
    {
        Description = "Record that who signs knows of this alarm. An operator signs.",
        HelpName = "KEY",
    };
    private readonly Option<string> _shelve = new("--shelve")
    {
        Description = "Take this alarm out of sight for --hours. It returns by itself. A setter signs.",
        HelpName = "KEY",
    };
    private readonly Option<string> _bringBack = new("--bring-back")
    {
        Description = "Bring this shelved alarm back. A setter signs.",
        HelpName = "KEY",
    };
    private readonly Option<double?> _hours = new("--hours")
    {
        Description = "How long to shelve it; more than 0, at most 24.",
        HelpName = "NUMBER",
    };

    public CellAlarms()
        : base(
            "alarms",
            "Lists what is abnormal at a cell, the most urgent first, and who acknowledged or shelved it. Measured counterparts outside "
                + "their limits are in cell history and at the station.",
            "errormatch cell alarms samples/cell/cell.json")
    {
        Options.Add(_acknowledge);
        Options.Add(_shelve);
        Options.Add(_bringBack);
        Options.Add(_hours);
        Validators.Add(result =>
        {
            if (new[] { _acknowledge, _shelve, _bringBack }.Count(o => result.GetResult(o) is not null) > 1)
            {
                result.AddError("Only one of --acknowledge, --shelve and --bring-back may be given.");
            }
            else if (result.GetResult(_shelve) is not null != result.GetResult(_hours) is not null)
            {
                result.AddError("--shelve and --hours belong together.");
            }
            else if (result.GetResult(_hours) is { } given && !given.Errors.Any() && result.GetValue(_hours) is not (> 0 and <= 24))
            {
                result.AddError("--hours is more than 0 and at most 24.");
            }
        });
    }

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        var (key, act) = arguments.GetValue(_acknowledge) is { } known ? (known, Act.Acknowledge)
            : arguments.GetValue(_shelve) is { } shelved ? (shelved, Act.Shelve)
            : (arguments.GetValue(_bringBack), Act.Shelve);
        return key is null
            ? WithStoreToRead(settings, store => List(settings, store))
            : WithExistingStore(settings, store =>
            {
                var users = new UserBook(store, TimeProvider.System);
                var by = Sign(users, arguments);
                users.Demand(by, act);
                var book = new AlarmBook(store, TimeProvider.System);
                var alarm = Alarm.Of(CellStatus.Of(settings, store, TimeProvider.System)).FirstOrDefault(a => a.Key == key)
                    ?? throw new DecisionException(
                        DecisionException.UnknownAlarm,
                        $"There is no alarm \"{key}\" now. errormatch cell alarms lists those that there are.");
                if (act == Act.Acknowledge)
                {
                    book.Acknowledge(alarm, by.Name);
                }
                else if (arguments.GetValue(_hours) is { } hours)
                {
                    book.Shelve(alarm, TimeSpan.FromHours(hours), by.Name);
                }
                else
                {
                    book.Unshelve(alarm, by.Name);
                }

                return List(settings, store);
            });
    }

    private static CellAlarmsAnswer List(CellSettings settings, CellStore store)
    {
        var (clock, marks) = (TimeProvider.System, new AlarmBook(store, TimeProvider.System).Read());
        return new(
            [
                .. Alarm.Of(CellStatus.Of(settings, store, clock)).OrderByDescending(a => a.Priority).ThenByDescending(a => a.Since)
                    .Select(a => (a, marks.GetValueOrDefault(a.Key, AlarmMark.None)))
            ],
            clock.GetUtcNow());
    }
}

/// <summary>The alarms of a cell.</summary>
internal sealed class CellAlarmsAnswer(IReadOnlyList<(Alarm Alarm, AlarmMark Mark)> alarms, DateTimeOffset now) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-alarms/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteStartArray("alarms");
        foreach (var (alarm, mark) in alarms)
        {
            json.WriteStartObject();
            json.WriteString("key", alarm.Key);
            json.WriteString("priority", Word(alarm.Priority));
            json.WriteString("what", What(alarm));
            WriteTime("since", alarm.Since);
            var isAcknowledged = mark.IsAcknowledged(alarm);
            json.WriteBoolean("isAcknowledged", isAcknowledged);
            if (isAcknowledged)
            {
                json.WriteString("acknowledgedBy", mark.AcknowledgedBy);
                WriteTime("acknowledgedAt", mark.AcknowledgedAt);
            }

            json.WriteBoolean("isShelved", mark.IsShelved(alarm, now));
            if (mark.IsShelved(alarm, now))
            {
                json.WriteString("shelvedBy", mark.ShelvedBy);
                WriteTime("shelvedUntil", mark.ShelvedUntil);
            }

            if (alarm.Correction is { } correction)
            {
                json.WriteNumber("correction", correction.Id);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();

        void WriteTime(string name, DateTimeOffset? time)
        {
            if (time is { } at)
            {
                json.WriteString(name, at.ToUniversalTime());
            }
        }
    }

    public override void WriteText(Page page)
    {
        if (alarms.Count == 0)
        {
            page.Line("No alarms.");
            return;
        }

        page.Table(
            ["key", "priority", "since", "acknowledged", "shelved until", "what"],
            alarms.Select(a => (IReadOnlyList<string>)
            [
                a.Alarm.Key,
                Word(a.Alarm.Priority),
                Time(a.Alarm.Since),
                a.Mark.IsAcknowledged(a.Alarm) ? $"{a.Mark.AcknowledgedBy}, {Time(a.Mark.AcknowledgedAt)}" : "no",
                a.Mark.IsShelved(a.Alarm, now) ? $"{Time(a.Mark.ShelvedUntil)} by {a.Mark.ShelvedBy}" : "",
                What(a.Alarm),
            ]));
    }

    private static string Word(AlarmPriority priority) => priority.ToString().ToLowerInvariant();

    private static string Time(DateTimeOffset? time) =>
        time?.UtcDateTime.ToString("yyyy-MM-dd HH:mm:ss'Z'", CultureInfo.InvariantCulture) ?? "";

    private static string What(Alarm alarm) => alarm.Kind switch
    {
        AlarmKind.NotRunning => "The cell does not run. Nothing is lost: start it again.",
        AlarmKind.Trouble => alarm.Trouble!.Statement.Sentence,
        AlarmKind.Tampered => alarm.Tampered!.Sentence,
        AlarmKind.Failed => $"{alarm.Correction!.Code}: {alarm.Correction.Reason}",
        AlarmKind.HeldUp => "Approved, and waits in line behind "
            + string.Join(", ", alarm.Behind.Select(c => c.Id.ToString(CultureInfo.InvariantCulture))) + ".",
        _ => throw new InvalidOperationException($"No words for {alarm.Kind}."),
    };
}
