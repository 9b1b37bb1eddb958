using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The state that results from the entries of an audit trail: the state and program of each correction, each user's rights, and
/// the codes of all rows. It finds what must not have happened: a step that is not allowed, an approval without the right to approve, a
/// program other than the computed one. It takes the entries as they are; <see cref="AuditChain"/> verifies that they are as
/// written.</summary>
internal sealed class AuditReplay
{
    private const string Console = "console";
    private readonly Dictionary<string, (string Code, long Seq)> _codes = new(StringComparer.Ordinal);
    private readonly Dictionary<long, RecordedCorrection> _corrections = [];
    private readonly Dictionary<string, RecordedPerson> _people = new(StringComparer.Ordinal);
    private readonly Dictionary<string, long> _lastInSlot = new(StringComparer.Ordinal);

    /// <summary>The first entry that must not exist; null if there is none.</summary>
    public AuditFault? Fault { get; private set; }

    /// <summary>The corrections by their numbers.</summary>
    public IReadOnlyDictionary<long, RecordedCorrection> Corrections => _corrections;

    /// <summary>The users by name key.</summary>
    public IReadOnlyDictionary<string, RecordedPerson> People => _people;

    /// <summary>The names of rows with codes.</summary>
    public IEnumerable<string> CodedRows => _codes.Keys;

    /// <summary>The highest number of a correction so far; 0 for none.</summary>
    public long Highest { get; private set; }

    /// <summary>The row name of each slot with the correction whose program was verified there last.</summary>
    public IEnumerable<KeyValuePair<string, long>> LastInSlot => _lastInSlot;

    /// <summary>The corrections that may take another step: those that have not ended, and of the released ones the last of each slot,
    /// which may be reverted.</summary>
    public IEnumerable<KeyValuePair<long, RecordedCorrection>> Unsettled
    {
        get
        {
            var last = _lastInSlot.Values.ToHashSet();
            return _corrections.Where(c => !CorrectionSteps.Of(c.Value.State).IsSettled
                || (!CorrectionSteps.IsEnd(c.Value.State) && last.Contains(c.Key)));
        }
    }

    /// <summary>Called with each step of a correction: its entry, its number, the state before and after.</summary>
    public Action<AuditEntry, long, CorrectionState?, CorrectionState>? Stepped { get; init; }

    /// <summary>Returns a correction that was forgotten; null for one that never was there.</summary>
    public Func<long, RecordedCorrection?>? Recall { get; init; }

    /// <summary>Forgets a correction that has ended.</summary>
    public void Forget(long id)
    {
        _corrections.Remove(id);
        _codes.Remove(CorrectionRow.NameOf(id));
    }

    /// <summary>Forgets all corrections but the unsettled ones.</summary>
    public void Settle()
    {
        var unsettled = Unsettled.Select(c => c.Key).ToHashSet();
        foreach (var id in _corrections.Keys.Where(id => !unsettled.Contains(id)).ToArray()) Forget(id);
    }

    /// <summary>Puts back a correction.</summary>
    public void Restore(long id, RecordedCorrection correction) => _corrections.Add(id, correction);

    /// <summary>Puts back the code of a row.</summary>
    public void Restore(string row, string code, long seq) => _codes.Add(row, (code, seq));

    /// <summary>Puts back a user.</summary>
    public void Restore(RecordedPerson person) => _people.Add(UserName.Key(person.Name), person);

    /// <summary>Puts back the highest number of a correction, and the last one in each slot.</summary>
    public void Restore(long highest, IEnumerable<(string Row, long Id)> lastInSlot)
    {
        Highest = highest;
        foreach (var (row, id) in lastInSlot) _lastInSlot.Add(row, id);
    }

    /// <summary>Replays the trail as a change sees it.</summary>
    /// <returns>Null if the trail is not intact.</returns>
    public static AuditReplay? Of(StoreTransaction change)
    {
        var replay = new AuditReplay();
        return AuditChain.Verify(
            Rows.Stream(change.Connection, AuditRow.Select + " ORDER BY seq", AuditRow.Read, null, change.Transaction),
            change.Head,
            change.Key,
            replay.Add) is null ? replay : null;
    }

    /// <summary>Adds the next entry.</summary>
    public void Add(AuditEntry entry)
    {
        foreach (var (name, code) in entry.RowCodes is null ? [] : CodedRow.Read(entry.RowCodes))
        {
            _codes[name] = (code, entry.Seq);
        }

        if (CorrectionRow.StateOrNull(entry.What) is { } state)
        {
            AddStep(entry, state);
        }
        else if (entry.What is "user-added" or "role-set" or "user-disabled" or "user-enabled" or "password-set"
            or "pin-set" or "badge-set" or "pin-removed" or "badge-removed")
        {
            AddPerson(entry);
        }
    }

    /// <summary>The required code of a row, and the number of the entry that names it; null if no entry does.</summary>
    public (string Code, long Seq)? CodeOf(string row) => _codes.TryGetValue(row, out var code) ? code : null;

    private void AddStep(AuditEntry entry, CorrectionState to)
    {
        if (SubjectOf(entry.Subject) is not var (id, file, program))
        {
            Fault ??= Of(entry, Recorded.NoCorrection.With(entry.Seq, entry.What, entry.Subject ?? ""));
            return;
        }

        var known = _corrections.GetValueOrDefault(id);
        if (known is null && Recall?.Invoke(id) is { } recalled) _corrections.Add(id, known = recalled);
        var from = known?.State;
        if (known is null)
        {
            _corrections.Add(id, known = new(file ?? ""));
            if (file is null || !CorrectionSteps.Of(to).MayBegin)
            {
                Mark(known, Of(entry, Recorded.NeverArrived.With(entry.Seq, id, entry.What)));
            }
        }
        else if (!CorrectionSteps.Allows(known.State, to))
        {
            Mark(known, Of(entry, Recorded.StepNotAllowed.With(entry.Seq, id, entry.What, CorrectionRow.Word(known.State))));
        }

        if (to == CorrectionState.Computed)
        {
            known.Program = program;
        }

        if (to is CorrectionState.Approved && ApprovalProblem(entry, from) is { } problem)
        {
            Mark(known, Of(entry, Recorded.ApprovalNotAllowed.With(entry.Seq, id, entry.Who, problem)));
        }
        else if (CorrectionSteps.Of(to).NamesProgram && (program is null || program != known.Program))
        {
            Mark(known, Of(entry, Recorded.OtherProgram.With(entry.Seq, id, program ?? "none", known.Program ?? "none")));
        }

        if (CorrectionSteps.IsEnd(to) && !CorrectionSteps.Of(to).NamesProgram)
        {
            // A tampered program ends with its correction: no further step uses it.
            known.Program = program ?? known.Program;
        }

        Highest = Math.Max(Highest, id);
        if (to == CorrectionState.Verified && entry.RowCodes is not null)
        {
            foreach (var (name, _) in CodedRow.Read(entry.RowCodes).Where(r => SlotRow.IsName(r.Name))) _lastInSlot[name] = id;
        }

        (known.State, known.Seq) = (to, entry.Seq);
        Stepped?.Invoke(entry, id, from, to);
    }

    // Null if the approval is valid: by the policy, by a person who had the right at that time, or an earlier one that continues when a
    // slot is given back.
    private Statement? ApprovalProblem(AuditEntry entry, CorrectionState? from)
    {
        if (entry.Who == AuditEntry.ByCell)
        {
            var isPolicy = entry.Basis.Is(Recorded.Policy) || entry.Basis.Is(Recorded.PolicyWithin) || EnglishRecord.IsPolicy(entry.Basis);
            return from == CorrectionState.Uploading || (from == CorrectionState.Proposed && isPolicy) ? null : Recorded.NotByPolicy.With();
        }

        return NotEntitled(entry.Who, Act.Approve);
    }

    private Statement? NotEntitled(string who, Act act) => _people.GetValueOrDefault(UserName.Key(who)) switch
    {
        null => Recorded.WasNobody.With(),
        { IsDisabled: true } => Recorded.WasDisabled.With(),
        var person when !person.May(act) => Recorded.WasOfRole.With(Rights.Word(person.Role), Rights.Word(Rights.LeastFor(act))),
        _ => null,
    };

    private void AddPerson(AuditEntry entry)
    {
        var name = entry.Subject?.Words ?? "";
        var key = UserName.Key(name);
        if (entry is { What: "user-added", Who: Console })
        {
            // Anyone who can write the store and has its keys may start over with new users; the entry itself shows it.
            _people.Clear();
            foreach (var row in _codes.Keys.Where(r => CredentialRow.IsName(r)
                || (r.StartsWith(Person.RowPrefix, StringComparison.Ordinal) && r != Person.NameOf(key))).ToArray())
            {
                _codes.Remove(row);
            }

            _people[key] = new(name, Role.Administrator, false, entry.Seq);
            return;
        }

        var isOwn = entry.What is "password-set" or "pin-set" or "pin-removed" && UserName.Key(entry.Who) == key;
        if (!isOwn && NotEntitled(entry.Who, Act.ManageUsers) is { } problem)
        {
            Fault ??= Of(entry, Recorded.UserNotAllowed.With(entry.Seq, entry.What, name, entry.Who, problem));
            return;
        }

        var word = entry.Basis.Is(Recorded.AsRole) || entry.Basis.Is(Recorded.ToRole)
            ? entry.Basis.Values[0].Words
            : EnglishRecord.RoleOf(entry.Basis);
        var role = word is null ? null : Rights.RoleOf(word);
        var before = _people.GetValueOrDefault(key);
        var after = entry.What switch
        {
            "user-added" when before is null && role is { } given => new RecordedPerson(name, given, false, entry.Seq),
            "role-set" when role is { } given => before is null ? null : before with { Role = given, Seq = entry.Seq },
            "user-disabled" => before is null ? null : before with { IsDisabled = true, Seq = entry.Seq },
            "user-enabled" => before is null ? null : before with { IsDisabled = false, Seq = entry.Seq },
            "password-set" or "pin-set" or "badge-set" or "pin-removed" or "badge-removed" => before,
            _ => null,
        };
        if (after is null)
        {
            Fault ??= Of(entry, Recorded.UserUnknown.With(entry.Seq, entry.What, name));
            return;
        }

        _people[key] = after;
    }

    private void Mark(RecordedCorrection correction, AuditFault fault)
    {
        correction.Fault ??= fault;
        Fault ??= fault;
    }

    private static AuditFault Of(AuditEntry entry, Statement message) => new(AuditFaultKind.NotAllowed, entry.Seq, message);

    /// <summary>The correction that an entry is about, with the file or the program that it names; null if it is about none.</summary>
    public static (long Id, string? File, string? Program)? SubjectOf(Statement? subject) =>
        subject is null ? null
        : EnglishRecord.CorrectionOf(subject) is { } earlier ? earlier
        : subject.Values is not [{ Words: { } digits }, ..]
            || !long.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var id) ? null
        : subject.Is(Recorded.File) ? (id, subject.Values[1].Words, null)
        : subject.Is(Recorded.Program) ? (id, null, subject.Values[1].Words)
        : subject.Is(Recorded.Correction) ? (id, null, null)
        : null;
}

/// <summary>What the audit trail says of a correction.</summary>
/// <param name="file">SHA-256 of the file that it arrived with.</param>
internal sealed class RecordedCorrection(string file)
{
    /// <summary>SHA-256 of the file that it arrived with.</summary>
    public string File => file;

    /// <summary>Its state.</summary>
    public CorrectionState State { get; set; }

    /// <summary>The computed program; null before that.</summary>
    public string? Program { get; set; }

    /// <summary>Number of the entry of its last step.</summary>
    public long Seq { get; set; }

    /// <summary>The first of its steps that was not allowed; null if there is none.</summary>
    public AuditFault? Fault { get; set; }
}

/// <summary>What the audit trail says of a user.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">The user's role.</param>
/// <param name="IsDisabled">True if the user may not sign in.</param>
/// <param name="Seq">Number of the entry that says so.</param>
internal sealed record RecordedPerson(string Name, Role Role, bool IsDisabled, long Seq)
{
    /// <summary>True if the user has the right.</summary>
    public bool May(Act act) => !IsDisabled && Rights.Allows(Role, act);
}
