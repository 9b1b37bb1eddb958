using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>What a control refuses, compiled so that a block is compared with few rules. Codes that no rule distinguishes share a bit;
/// codes that stay in force have the lowest bits.</summary>
internal sealed class RefusalTable
{
    /// <summary>No control is known to refuse anything.</summary>
    public static readonly RefusalTable Empty = new([]);

    /// <summary>Letters that rules remember from block to block, each with a bit behind the codes in force.</summary>
    public static readonly (char Letter, ulong Bit)[] Remembered = [('F', 1ul << 63), ('S', 1ul << 62), ('T', 1ul << 61)];

    /// <summary>Keys of an entry whose text names codes and functions.</summary>
    public static readonly string[] SetsOfCodes = ["codes", "unless", "while", "whileNot", "before", "twoOf", "inForce", "ends"];

    /// <summary>Bits of all letters.</summary>
    public const uint AllLetters = (1u << 26) - 1;

    /// <summary>The bit of polar coordinates of LinuxCNC.</summary>
    public const uint Polar = 1u << 26;

    private const int MostInForce = 61;
    private const int MostBits = 127;
    private const int FirstFunction = DialectTables.Codes;
    private const byte NoGroup = byte.MaxValue;

    private readonly byte[] _bitOf = [];
    private readonly byte[] _groupOf = [];
    private readonly List<ulong> _groups = [];
    private readonly List<ulong> _ends = [];
    private readonly RefusalRule[][] _ofCode = [];
    private readonly RefusalRule[][] _ofLetter = [];
    private readonly List<(UInt128 Codes, RefusalRule Rule)> _twoOf = [];
    private readonly List<(UInt128 Codes, ulong Before, ulong Letters)> _clears = [];

    public RefusalTable(IReadOnlyList<JsonItem> entries)
    {
        if (entries.Count == 0)
        {
            return;
        }

        var classes = new CodeClasses();
        foreach (var entry in entries)
        {
            classes.Divide(entry);
        }

        _bitOf = classes.Bits();
        HasTooMany = classes.Count > MostBits || classes.InForce > MostInForce;
        if (HasTooMany)
        {
            return;
        }

        _groupOf = new byte[MostBits + 2];
        Array.Fill(_groupOf, NoGroup);
        var rules = new List<RefusalRule>();
        foreach (var entry in entries)
        {
            AtStart |= AddGroup(entry);
        }

        foreach (var entry in entries)
        {
            if (RuleOf(entry) is not { } rule)
            {
                continue;
            }

            if (entry.Find("rises") is not null)
            {
                Rising = rule;
            }
            else
            {
                rules.Add(rule);
            }
        }

        Rules = rules;
        Motion = Groups(Set("G0"));
        ArcCodes = Set("G2 G3");
        _ofLetter = new RefusalRule[27][];
        for (var i = 0; i < _ofLetter.Length; i++)
        {
            var bit = 1u << i;
            _ofLetter[i] = [.. rules.Where(r => r.Letters.Length > 0 && (r.Letters[0] & bit) != 0)];
        }

        _ofCode = new RefusalRule[classes.Count + 1][];
        for (var i = 0; i < _ofCode.Length; i++)
        {
            var bit = UInt128.One << i;
            _ofCode[i] = [.. rules.Where(r => r.Letters.Length == 0 && r.Codes.Length > 0 && (r.Codes[0] & bit) != 0)];
        }

        Others = [.. rules.Where(r => r.Letters.Length == 0 && r.Codes.Length == 0)];
        Straight = new(this);
    }

    /// <summary>True if more codes are distinguished than can be.</summary>
    public bool HasTooMany { get; }

    public bool IsEmpty => _bitOf.Length == 0;

    public IReadOnlyList<RefusalRule> Rules { get; } = [];

    /// <summary>Rules that neither a letter nor a code calls.</summary>
    public RefusalRule[] Others { get; } = [];

    /// <summary>Rules for two codes of a set in one block.</summary>
    public IReadOnlyList<(UInt128 Codes, RefusalRule Rule)> TwoOf => _twoOf;

    /// <summary>The codes in force when a program begins.</summary>
    public ulong AtStart { get; }

    /// <summary>Nothing is known to be in force, and all letters may have been given.</summary>
    public static ulong Open { get; } = Remembered.Aggregate(0ul, (bits, letter) => bits | letter.Bit);

    /// <summary>A cycle whose depth is above its R plane; null if the control is not known to refuse it.</summary>
    public RefusalRule? Rising { get; }

    /// <summary>The codes of motions.</summary>
    public ulong Motion { get; }

    /// <summary>The codes of arcs.</summary>
    public UInt128 ArcCodes { get; }

    /// <summary>When a straight move needs no look at the rules.</summary>
    public StraightRefusals Straight { get; } = StraightRefusals.None;

    /// <summary>The bit of a G code, in tenths; 0 if no rule names it.</summary>
    public UInt128 BitOf(int tenths) => BitAt(tenths);

    /// <summary>The bit of an M function; 0 if no rule names it.</summary>
    public UInt128 BitOfFunction(int function) => (uint)function < DialectTables.Functions ? BitAt(FirstFunction + function) : 0;

    /// <summary>The rules that a code calls, by its bit.</summary>
    public RefusalRule[] OfCode(int bit) => _ofCode[bit];

    /// <summary>The rules that a letter calls; A is 0.</summary>
    public RefusalRule[] OfLetter(int letter) => _ofLetter[letter];

    /// <summary>What is in force after a code.</summary>
    /// <param name="inForce">What was before.</param>
    /// <param name="code">The bit of the code.</param>
    /// <param name="all">The bits of all codes of its block.</param>
    public ulong After(ulong inForce, UInt128 code, UInt128 all)
    {
        var bit = (ulong)code;
        if (bit == 0)
        {
            return inForce;
        }

        var group = _groupOf[System.Numerics.BitOperations.TrailingZeroCount(bit)];
        if (group == NoGroup)
        {
            return inForce;
        }

        // A code that only ends what is in force does nothing next to another one of its group.
        var loses = (_ends[group] & bit) != 0 && ((ulong)all & _groups[group] & ~_ends[group]) != 0;
        return loses ? inForce : (inForce & ~_groups[group]) | bit;
    }

    /// <summary>The remembered letters that codes of a block make invalid.</summary>
    /// <param name="stated">The codes.</param>
    /// <param name="before">What was in force before the block.</param>
    public ulong ClearedBy(UInt128 stated, ulong before)
    {
        var cleared = 0ul;
        foreach (var (codes, needed, letters) in _clears)
        {
            cleared |= (codes & stated) != 0 && (needed == 0 || (needed & before) != 0) ? letters : 0;
        }

        return cleared;
    }

    /// <summary>All codes of the groups of some codes.</summary>
    public ulong Groups(UInt128 codes)
    {
        var all = 0ul;
        foreach (var group in _groups)
        {
            all |= ((ulong)codes & group) != 0 ? group : 0;
        }

        return all;
    }

    private UInt128 BitAt(int place) =>
        (uint)place < (uint)_bitOf.Length && _bitOf[place] is > 0 and var bit ? UInt128.One << (bit - 1) : 0;

    private UInt128 Set(string text)
    {
        UInt128 set = 0;
        foreach (var place in CodeClasses.PlacesOf(text))
        {
            set |= BitAt(place);
        }

        return set;
    }

    // What is in force of it at first.
    private ulong AddGroup(JsonItem entry)
    {
        if (entry.Find("inForce") is not { } codes)
        {
            return 0;
        }

        var ends = entry.Find("ends") is { } end ? (ulong)Set(end.Text) : 0;
        var group = (ulong)Set(codes.Text) | ends;
        for (var bits = group; bits != 0; bits &= bits - 1)
        {
            _groupOf[System.Numerics.BitOperations.TrailingZeroCount(bits)] = (byte)_groups.Count;
        }

        _groups.Add(group);
        _ends.Add(ends);
        return entry.Find("atStart") is { } start ? (ulong)Set(start.Text) : 0;
    }

    // Null for an entry that only says what stays in force, or what is accepted.
    private RefusalRule? RuleOf(JsonItem entry)
    {
        var rule = new RefusalRule(entry["name"].Text, entry["statement"].Text, IsAssumed(entry["source"].Text))
        {
            Codes = [.. Parts(entry, "codes").Select(Set)],
            Unless = entry.Find("unless") is { } unless ? Set(unless.Text) : 0,
            While = [.. Parts(entry, "while").Select(p => (ulong)Set(p))],
            WhileNot = entry.Find("whileNot") is { } not ? (ulong)Set(not.Text) : 0,
            Before = entry.Find("before") is { } before ? (ulong)Set(before.Text) : 0,
            Begins = entry.Find("begins")?.Flag == true,
            Letters = [.. Parts(entry, "letters").Select(LettersOf)],
            Missing = LettersOf(entry.Find("missing")?.Text ?? ""),
            Repeated = LettersOf(entry.Find("repeated")?.Text ?? ""),
            Ungiven = Remember(entry, "notYet"),
            Where = [.. (entry.Find("where")?.Text ?? "").Split(' ', StringSplitOptions.RemoveEmptyEntries)
                .Select(w => ((byte)w[0], double.Parse(w.AsSpan(1), System.Globalization.CultureInfo.InvariantCulture)))],
            Values = entry.Find("values") is { } values ? ValuesOf(values) : null,
            IsClear = entry.Find("clear")?.Flag == true,
            MostFunctions = (int)(entry.Find("mostFunctions")?.Number ?? int.MaxValue),
        };
        if (entry.Find("clears") is not null)
        {
            _clears.Add((rule.Codes[0], rule.Before, Remember(entry, "clears")));
            return null;
        }


        if (entry.Find("twoOf") is { } two)
        {
            _twoOf.Add((Set(two.Text), rule));
            return null;
        }

        return entry.Find("rises") is null && rule is { Codes.Length: 0, Letters.Length: 0, Repeated: 0, MostFunctions: int.MaxValue }
            ? null : rule;
    }

    private static ulong Remember(JsonItem entry, string key) =>
        Remembered.Where(r => entry.Find(key)?.Text[0] == r.Letter).Aggregate(0ul, (bits, r) => bits | r.Bit);

    private static bool IsAssumed(string source) => source.StartsWith("assumed", StringComparison.OrdinalIgnoreCase);

    private static string[] Parts(JsonItem entry, string key) =>
        entry.Find(key)?.Text.Split('&', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries) ?? [];

    /// <summary>A letter as a bit; bit 0 is A.</summary>
    public static uint Bit(char letter) => letter == '@' ? Polar : 1u << (letter - 'A');

    private static uint LettersOf(string text) =>
        text.Where(c => char.IsAsciiLetterUpper(c) || c == '@').Aggregate(0u, (letters, letter) => letters | Bit(letter));

    private static RefusalValues ValuesOf(JsonItem values) => new(
        values.Find("whole")?.Flag == true,
        values.Find("least")?.Number ?? double.NegativeInfinity,
        values.Find("above")?.Number ?? double.NegativeInfinity,
        values.Find("most")?.Number ?? double.PositiveInfinity,
        [.. (values.Find("oneOf")?.Items ?? []).Select(i => i.Number)]);

    /// <summary>Divides all codes into classes that no rule distinguishes.</summary>
    private sealed class CodeClasses
    {
        private readonly int[] _classOf = new int[DialectTables.Codes + DialectTables.Functions];
        private readonly HashSet<int> _inForce = [];
        private int _last;

        public int Count { get; private set; }

        public int InForce { get; private set; }

        /// <summary>The places of the codes and functions in a text; the sign between sets does not matter.</summary>
        public static IEnumerable<int> PlacesOf(string text)
        {
            var subjects = new List<SubjectRange>();
            foreach (var word in text.Split([' ', '&'], StringSplitOptions.RemoveEmptyEntries))
            {
                SubjectRange.TryRead(word, word[0] == 'M' ? DialectTopic.Function : DialectTopic.Code, subjects, out _);
            }

            return subjects.SelectMany(s => Enumerable.Range(0, ((s.Last - s.First) / s.Step) + 1).Select(i =>
                s.First + (i * s.Step) + (s.Word == "M" ? FirstFunction : 0)));
        }

        public void Divide(JsonItem entry)
        {
            foreach (var key in SetsOfCodes)
            {
                foreach (var set in entry.Find(key)?.Text.Split('&') ?? [])
                {
                    var places = PlacesOf(set).ToArray();
                    if (key == "codes" && entry.Find("begins")?.Flag == true)
                    {
                        // Which of them is in force matters.
                        Array.ForEach(places, p => Split([p]));
                    }
                    else
                    {
                        Split(places);
                    }

                    if (key is "inForce" or "ends")
                    {
                        _inForce.UnionWith(places);
                    }
                }
            }
        }

        /// <summary>The bit of each place, from 1; 0 if no rule names it.</summary>
        public byte[] Bits()
        {
            var bitOf = new Dictionary<int, byte> { [0] = 0 };
            foreach (var place in _inForce.Order())
            {
                bitOf.TryAdd(_classOf[place], (byte)Math.Min(bitOf.Count, byte.MaxValue));
            }

            InForce = bitOf.Count - 1;
            var bits = new byte[_classOf.Length];
            for (var i = 0; i < bits.Length; i++)
            {
                if (_classOf[i] != 0)
                {
                    bitOf.TryAdd(_classOf[i], (byte)Math.Min(bitOf.Count, byte.MaxValue));
                    bits[i] = bitOf[_classOf[i]];
                }
            }

            Count = bitOf.Count - 1;
            return bits;
        }

        private void Split(int[] places)
        {
            var renamed = new Dictionary<int, int>();
            foreach (var place in places)
            {
                if (!renamed.TryGetValue(_classOf[place], out var now))
                {
                    now = renamed[_classOf[place]] = ++_last;
                }

                _classOf[place] = now;
            }
        }
    }
}

/// <summary>When a straight move of plain words needs no look at the rules.</summary>
internal sealed class StraightRefusals
{
    /// <summary>Nothing is refused.</summary>
    public static readonly StraightRefusals None = new();

    /// <summary>Coordinates, also those of the usual other axes, feed and number. A block with other letters is compared with all
    /// rules.</summary>
    public static uint Letters { get; } = "ABCUVWXYZFN".Aggregate(0u, (letters, letter) => letters | RefusalTable.Bit(letter));

    private StraightRefusals() => IsFree = true;

    public StraightRefusals(RefusalTable table)
    {
        var moves = table.BitOf(0) | table.BitOf(10);
        (RapidBit, LineBit) = ((ulong)table.BitOf(0) & table.Motion, (ulong)table.BitOf(10) & table.Motion);
        foreach (var rule in table.Rules)
        {
            if (CanConcern(rule, moves))
            {
                Needed |= rule.Ungiven;
                var guards = rule.While.Aggregate(0ul, (bits, set) => bits | set);
                Excluded |= guards;
                ChecksNumber |= rule.Values is not null && rule.Letters.Length > 0 && (rule.Letters[0] & RefusalTable.Bit('N')) != 0;
                IsNever |= rule.Ungiven == 0 && guards == 0 && rule.Values is null;
            }
        }

        IsNever |= table.Others.Any(r => r.Repeated == 0 && r.MostFunctions < 1);
    }

    /// <summary>No straight move is refused.</summary>
    public bool IsFree { get; }

    /// <summary>Every straight move must be compared with the rules.</summary>
    public bool IsNever { get; }

    /// <summary>What must be in force or given, so that none can be refused.</summary>
    public ulong Needed { get; }

    /// <summary>What must not be in force.</summary>
    public ulong Excluded { get; }

    /// <summary>The bit of G0 among what is in force; 0 if the rules do not follow it.</summary>
    public ulong RapidBit { get; }

    /// <summary>The same of G1.</summary>
    public ulong LineBit { get; }

    public bool ChecksNumber { get; }

    // A move by G0 or G1 that is in force or stated, with coordinates, feed and number only.
    private static bool CanConcern(RefusalRule rule, UInt128 moves) =>
        (rule.Codes.Length == 0 || Array.TrueForAll(rule.Codes, c => (c & moves) != 0))
        && (rule.Letters.Length == 0 || Array.TrueForAll(rule.Letters, l => (l & Letters) != 0))
        && (rule.Codes.Length > 0 || rule.Letters.Length > 0)
        && (moves == 0 || (rule.Unless & moves) != moves) && rule.Where.Length == 0;
}
