using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>The variables of a running program. Values left in the control by an earlier program, and values that only the machine knows,
/// are unknown until the program assigns them.</summary>
/// <remarks>
/// Fanuc: #1 to #33 belong to a macro call and begin vacant; #100 to #999 are common. LinuxCNC: #1 to #30 and names belong to a
/// subroutine; #31 to #5000 and names with a leading underscore are global; unassigned numbers are 0. Siemens: R parameters are common;
/// DEF variables belong to a program level. Okuma: VC1 and V1 are common; names belong to a program level.
/// </remarks>
internal sealed class NcVariables
{
    private readonly NcSyntax _syntax;
    private readonly int _localCount;
    private readonly Dictionary<int, NcValue> _numbered = [];

    // Apart from the program's own, since they are forgotten often.
    private readonly Dictionary<int, NcValue> _machine = [];
    private readonly Dictionary<string, VariableArray> _global = new(StringComparer.Ordinal);
    private readonly Stack<Level> _levels = new();

    // Of the assumed values, those that the program has replaced, and those that it has read.
    private readonly AssumedValues _assumed;
    private readonly HashSet<string> _replaced = new(StringComparer.Ordinal);
    private readonly SortedSet<string> _used = new(StringComparer.Ordinal);

    public NcVariables(NcSyntax syntax, AssumedValues? assumed = null)
    {
        _syntax = syntax;
        _assumed = assumed ?? AssumedValues.None;
        _localCount = syntax switch { NcSyntax.LinuxCnc => 31, NcSyntax.Siemens => 0, _ => 34 };
        Enter();
        if (syntax == NcSyntax.LinuxCnc)
        {
            Return(null);
        }
    }

    public VariableNames Names { get; } = new();

    /// <summary>The assumed values that were read.</summary>
    public IReadOnlySet<string> Used => _used;

    /// <summary>The variable that was read last of those that only the machine knows; null if there was none.</summary>
    public string? LastUnknown { get; private set; }

    /// <summary>Increases with every change of a value: while it is constant, the program's knowledge is the same.</summary>
    public long Version { get; private set; }

    /// <summary>Begins a new level of variables, as a call does.</summary>
    public void Enter()
    {
        var locals = new NcValue[_localCount];
        if (_syntax == NcSyntax.LinuxCnc)
        {
            Array.Fill(locals, NcValue.Zero);
        }

        _levels.Push(new(locals));
        Version++;
    }

    /// <summary>Ends the innermost level.</summary>
    /// <param name="arguments">What the call that began it had set.</param>
    public void Leave(IReadOnlyList<(VariablePlace Place, NcValue Value)> arguments)
    {
        var left = _levels.Pop();
        Version++;
        if (_syntax == NcSyntax.Okuma && _levels.TryPeek(out var level))
        {
            // Whether a called program changes the variables of its caller: sources disagree. What its call sets is its own.
            var own = arguments.Select(a => a.Place.Name).Where(n => !level.Named.ContainsKey(n!)).ToHashSet(StringComparer.Ordinal);
            foreach (var name in left.Named.Keys.Where(n => !own.Contains(n)))
            {
                level.Named[name] = new(VariableType.Real, 1, 1);
                level.Named[name].Values[0] = NcValue.Unknown;
            }
        }
    }

    /// <summary>True if a program that called this one has a variable of this name.</summary>
    public bool KnowsOutside(string name) => _levels.Skip(1).Any(l => l.Named.ContainsKey(name));

    /// <summary>Sets what a LinuxCNC subroutine returns, if anything: <c>#&lt;_value&gt;</c> and
    /// <c>#&lt;_value_returned&gt;</c>.</summary>
    public void Return(NcValue? value)
    {
        Write(VariablePlace.Named("_VALUE"), value ?? NcValue.Zero);
        Write(VariablePlace.Named("_VALUE_RETURNED"), NcValue.Of(value is not null));
    }

    /// <summary>Number of times the program wrote machine data: offsets, modes and positions.</summary>
    public long MachineWrites { get; private set; }

    /// <summary>Marks values that the machine may have changed itself (offsets, positions) as unknown.</summary>
    public void ForgetMachine()
    {
        _machine.Clear();
        Version++;
    }

    /// <summary>Reads a variable. The error says why it cannot be read; otherwise it is null.</summary>
    public NcValue Read(VariablePlace place, out string? error)
    {
        if (Assumed(place) is { } stated)
        {
            error = null;
            return stated;
        }

        var read = ReadOwn(place, out error);
        LastUnknown = read.IsUnknown ? NameOf(place) ?? LastUnknown : LastUnknown;
        return read;
    }

    /// <summary>The value that somebody stated for a variable that the program has not set; null if nobody did.</summary>
    public NcValue? Assumed(VariablePlace place)
    {
        if (_assumed.Count == 0 || NameOf(place) is not { } name || _replaced.Contains(name) || _assumed.Of(name) is not { } value)
        {
            return null;
        }

        _used.Add(name);
        return NcValue.Of(value);
    }

    private NcValue ReadOwn(VariablePlace place, out string? error)
    {
        error = null;
        switch (place.Kind)
        {
            case VariableKind.Machine:
                return NcValue.Unknown;
            case VariableKind.Numbered:
                error = NumberError(place.Number, assigned: false);
                return error is null ? ReadNumber(place.Number) : NcValue.Unknown;
            default:
                return ReadName(place, out error);
        }
    }

    /// <summary>Assigns a value to a variable.</summary>
    /// <returns>Why it cannot be assigned; null if it was.</returns>
    public string? Write(VariablePlace place, NcValue value)
    {
        if (_assumed.Count > 0 && NameOf(place) is { } name)
        {
            _replaced.Add(name);
        }

        switch (place.Kind)
        {
            case VariableKind.Machine:
                MachineWrites++;
                return null;
            case VariableKind.Numbered:
                var error = NumberError(place.Number, assigned: true);
                if (error is null)
                {
                    MachineWrites += IsOfMachine(place.Number) ? 1 : 0;
                    WriteNumber(place.Number, value);
                }

                return error;
            default:
                return WriteName(place, value);
        }
    }

    /// <summary>True if a variable of this name has a value.</summary>
    public bool Knows(string name) => Find(name) is not null;

    /// <summary>The program's own variable or array with a name; null if there is none.</summary>
    public VariableArray? Find(string name) =>
        _levels.Peek().Named.TryGetValue(name, out var local) ? local : _global.GetValueOrDefault(name);

    /// <summary>Defines a variable or an array on the current level, replacing an earlier one with its name.</summary>
    public VariableArray Define(string name, VariableType type, int rows, int columns)
    {
        Version++;
        Names.Add(name);
        return _levels.Peek().Named[name] = new(type, rows, columns);
    }

    /// <summary>All values, so that two runs can be compared.</summary>
    public Dictionary<VariableKey, NcValue> Snapshot()
    {
        var values = new Dictionary<VariableKey, NcValue>();
        foreach (var (number, value) in _numbered)
        {
            values[new(-1, null, number)] = value;
        }

        foreach (var (name, variable) in _global)
        {
            Add(-1, name, variable.Values);
        }

        var depth = 0;
        foreach (var level in _levels)
        {
            Add(depth, null, level.Numbered);
            foreach (var (name, variable) in level.Named)
            {
                Add(depth, name, variable.Values);
            }

            depth++;
        }

        foreach (var name in _replaced)
        {
            values[new(-2, name, 0)] = NcValue.Zero;
        }

        return values;

        void Add(int level, string? name, NcValue[] of)
        {
            for (var i = 0; i < of.Length; i++)
            {
                values[new(level, name, i)] = of[i];
            }
        }
    }

    /// <summary>Makes a variable unknown; false if there is none of this key here.</summary>
    public bool Forget(VariableKey key)
    {
        Version++;
        if (key.Level == -2)
        {
            return _replaced.Add(key.Name!) || true;
        }

        if (key is { Level: -1, Name: null })
        {
            _numbered[key.Number] = NcValue.Unknown;
            _replaced.UnionWith(NameOf(VariablePlace.Numbered(key.Number)) is { } name ? [name] : []);
            return true;
        }

        var level = key.Level < 0 ? null : _levels.ElementAtOrDefault(key.Level);
        var values = key.Name is null ? level?.Numbered : (level?.Named ?? _global).GetValueOrDefault(key.Name)?.Values;
        if (values is null || (uint)key.Number >= (uint)values.Length)
        {
            return false;
        }

        values[key.Number] = NcValue.Unknown;
        return true;
    }

    // As a program writes it; null for what has no name. The variables of a call are not those that somebody stated.
    private string? NameOf(VariablePlace place) => place.Kind switch
    {
        VariableKind.Numbered when place.Number < _localCount && _levels.Count > 1 => null,
        VariableKind.Numbered => string.Create(CultureInfo.InvariantCulture, $"{(_syntax == NcSyntax.Siemens ? "R" : "#")}{place.Number}"),
        VariableKind.Machine => place.Name,
        _ when place is { Name: not null, Number: 0 } => _syntax switch
        {
            NcSyntax.LinuxCnc => $"#<{place.Name}>",
            NcSyntax.Siemens => place.Name,
            _ => place.Name.TrimStart('_'),
        },
        _ => null,
    };

    private bool IsOfMachine(int number) =>
        _syntax switch { NcSyntax.LinuxCnc => number > 5000, NcSyntax.Siemens => false, _ => number >= 1000 };

    private string? NumberError(int number, bool assigned)
    {
        if (_syntax == NcSyntax.LinuxCnc && assigned && LinuxCncNames.IsReadOnly(number))
        {
            return string.Create(CultureInfo.InvariantCulture, $"the variable #{number} can only be read");
        }

        var exists = _syntax switch
        {
            NcSyntax.LinuxCnc => number is > 0 and <= LinuxCncNames.LastNumber,
            NcSyntax.Siemens => number >= 0,
            _ => (number > 0 || (number == 0 && !assigned)) && number is not (> 33 and < 100),
        };
        return exists
            ? null
            : string.Create(
                CultureInfo.InvariantCulture,
                $"there is no variable {(_syntax == NcSyntax.Siemens ? "R" : "#")}{number}{(number == 0 ? " to be assigned" : "")}");
    }

    private NcValue ReadNumber(int number)
    {
        if (number < _localCount)
        {
            return _levels.Peek().Numbered[number];
        }

        // Fanuc's system variables can change even after an assignment (timers, signals, offsets that G10 changes).
        if (_syntax == NcSyntax.Iso && IsOfMachine(number))
        {
            return NcValue.Unknown;
        }

        if ((IsOfMachine(number) ? _machine : _numbered).TryGetValue(number, out var value))
        {
            return value;
        }

        return _syntax == NcSyntax.LinuxCnc && !IsOfMachine(number) ? NcValue.Zero : NcValue.Unknown;
    }

    private void WriteNumber(int number, NcValue value)
    {
        if (number < _localCount)
        {
            ref var local = ref _levels.Peek().Numbered[number];
            Version += local == value ? 0 : 1;
            local = value;
            return;
        }

        var numbered = IsOfMachine(number) ? _machine : _numbered;
        Version += numbered.TryGetValue(number, out var old) && old == value ? 0 : 1;
        numbered[number] = value;
    }

    private NcValue ReadName(VariablePlace place, out string? error)
    {
        error = null;
        if (Find(place.Name!) is { } variable)
        {
            if ((uint)place.Number < (uint)variable.Values.Length)
            {
                return variable.Values[place.Number];
            }

            error = $"{place.Name} has no element of this number";
            return NcValue.Unknown;
        }

        if (_syntax == NcSyntax.LinuxCnc && !LinuxCncNames.IsOfMachine(place.Name!))
        {
            error = $"#<{place.Name!.ToLowerInvariant()}> has never been assigned";
        }

        // Siemens: a name that the program does not define is machine data.
        return NcValue.Unknown;
    }

    private string? WriteName(VariablePlace place, NcValue value)
    {
        var variable = Find(place.Name!);
        if (variable is null)
        {
            if (_syntax == NcSyntax.Siemens)
            {
                return null;
            }

            if (LinuxCncNames.IsOfMachine(place.Name!))
            {
                return $"#<{place.Name!.ToLowerInvariant()}> is the machine's own and cannot be assigned";
            }

            variable = new(VariableType.Real, 1, 1);
            (place.Name![0] == '_' ? _global : _levels.Peek().Named)[place.Name] = variable;
            Version++;
        }

        if ((uint)place.Number >= (uint)variable.Values.Length)
        {
            return $"{place.Name} has no element of this number";
        }

        ref var old = ref variable.Values[place.Number];
        var kept = variable.Converted(value);
        Version += old == kept ? 0 : 1;
        old = kept;
        return null;
    }

    private sealed class Level(NcValue[] numbered)
    {
        public NcValue[] Numbered { get; } = numbered;

        public Dictionary<string, VariableArray> Named { get; } = new(StringComparer.Ordinal);
    }
}
