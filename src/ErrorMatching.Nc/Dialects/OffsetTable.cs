namespace ErrorMatching.Nc;

/// <summary>What a G10 block with a certain L does, as a dialect states it.</summary>
/// <param name="Means">What it writes.</param>
/// <param name="Names">The offsets that P1, P2 and so on name, in the ways in which a program can choose them.</param>
/// <param name="ZeroIsActive">True if P0 is the active offset; otherwise it is one of the machine.</param>
/// <param name="IsAssumed">True if nobody gave a source for it.</param>
internal sealed record OffsetTable(OffsetWriting Means, IReadOnlyList<OffsetNames> Names, bool ZeroIsActive, bool IsAssumed)
{
    /// <summary>The offset that a P word names; null if it names none that a program can choose.</summary>
    public (int Code, int Number)? Offset(int number) => Names.Count > 0 ? Names[0].At(number - 1) : null;

    /// <summary>Whether an offset is among those of this table, and its place there.</summary>
    public bool TryFind((int Code, int Number) offset, out int index)
    {
        foreach (var names in Names)
        {
            if (names.IndexOf(offset) is >= 0 and var found)
            {
                index = found;
                return true;
            }
        }

        index = -1;
        return false;
    }
}

/// <summary>What a G10 block writes.</summary>
internal enum OffsetWriting : byte
{
    /// <summary>Anything: no origin and no place is known behind it.</summary>
    Unknown,

    /// <summary>The origin of a work offset in machine coordinates, under G91 too.</summary>
    Origin,

    /// <summary>The origin of a work offset in machine coordinates, under G91 by how much it moves.</summary>
    OriginByDistance,

    /// <summary>The origin of a work offset in machine coordinates; what G91 changes is not known.</summary>
    AbsoluteOrigin,

    /// <summary>The origin of a work offset so that the tool's place gets the coordinates of the block.</summary>
    TouchOff,

    /// <summary>Data of tools: a length that is active may change.</summary>
    Tool,
}
