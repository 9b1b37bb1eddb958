using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;

namespace ErrorMatching.Nc;

/// <summary>The arguments of one function, stored without allocating.</summary>
internal struct ArgumentList
{
    private Storage _storage;

    public int Count { get; private set; }

    [UnscopedRef]
    public readonly ReadOnlySpan<NcValue> Values => ((ReadOnlySpan<NcValue>)_storage)[..Count];

    public void Add(NcValue value) => _storage[Count++] = value;

    // No function has more than three.
    [InlineArray(3)]
    private struct Storage
    {
        private NcValue _first;
    }
}
