namespace ErrorMatching.Nc;

/// <summary>New bytes for a range of a program. Everything outside patches is copied, not printed.</summary>
/// <param name="Start">First byte that is replaced.</param>
/// <param name="Length">Number of bytes that are replaced; 0 inserts.</param>
/// <param name="Bytes">What stands there instead.</param>
public readonly record struct NcPatch(int Start, int Length, ReadOnlyMemory<byte> Bytes)
{
    /// <summary>Applies patches to a program's bytes.</summary>
    /// <param name="bytes">The original bytes.</param>
    /// <param name="patches">Patches in ascending order that do not overlap.</param>
    /// <exception cref="ArgumentException">The patches overlap or are out of order.</exception>
    public static byte[] Apply(ReadOnlySpan<byte> bytes, IReadOnlyList<NcPatch> patches)
    {
        var length = bytes.Length;
        foreach (var patch in patches)
        {
            length += patch.Bytes.Length - patch.Length;
        }

        var result = GC.AllocateUninitializedArray<byte>(length);
        var (from, to) = (0, 0);
        foreach (var patch in patches)
        {
            if (patch.Start < from || patch.Start + patch.Length > bytes.Length)
            {
                throw new ArgumentException("Patches must lie inside the program, in ascending order, without overlap.", nameof(patches));
            }

            bytes[from..patch.Start].CopyTo(result.AsSpan(to));
            to += patch.Start - from;
            patch.Bytes.Span.CopyTo(result.AsSpan(to));
            to += patch.Bytes.Length;
            from = patch.Start + patch.Length;
        }

        bytes[from..].CopyTo(result.AsSpan(to));
        return result;
    }
}
