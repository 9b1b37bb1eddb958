namespace ErrorMatching.Nc;

/// <summary>Stores one string per name, so that reading a name again allocates nothing. Ignores case and spaces.</summary>
internal sealed class VariableNames
{
    /// <summary>Maximum length of a name.</summary>
    public const int MaxLength = 128;

    private readonly HashSet<string> _known = new(StringComparer.Ordinal);
    private HashSet<string>.AlternateLookup<ReadOnlySpan<char>> _lookup;
    private bool _isLookedUp;

    /// <summary>The name in upper case without spaces; null if it is too long.</summary>
    public string? Of(ReadOnlySpan<byte> spelling) => Find(spelling, adds: true);

    /// <summary>The same for a stored name; null for any other.</summary>
    public string? Known(ReadOnlySpan<byte> spelling) => Find(spelling, adds: false);

    /// <summary>Stores a name.</summary>
    public void Add(string name) => _known.Add(name);

    private string? Find(ReadOnlySpan<byte> spelling, bool adds)
    {
        Span<char> name = stackalloc char[MaxLength];
        var length = 0;
        foreach (var c in spelling)
        {
            if (c is (byte)' ' or (byte)'\t')
            {
                continue;
            }

            if (length == MaxLength)
            {
                return null;
            }

            name[length++] = char.ToUpperInvariant((char)c);
        }

        if (!_isLookedUp)
        {
            // Most programs read no names.
            (_lookup, _isLookedUp) = (_known.GetAlternateLookup<ReadOnlySpan<char>>(), true);
        }

        if (_lookup.TryGetValue(name[..length], out var known) || !adds)
        {
            return known;
        }

        known = new string(name[..length]);
        _known.Add(known);
        return known;
    }
}
