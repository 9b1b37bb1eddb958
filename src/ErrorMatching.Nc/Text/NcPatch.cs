using System.Runtime.InteropServices;

namespace ErrorMatching.Nc;

/// <summary>New bytes for a range of a program. Everything outside patches is copied, not printed again.</summary>
/// <param name="Start">First replaced byte.</param>
/// <param name="Length">Number of replaced bytes; 0 inserts.</param>
/// <param name="Bytes">The replacement.</param>
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
        Copy(bytes, 0, patches is List<NcPatch> list ? CollectionsMarshal.AsSpan(list) : [.. patches], result);
        return result;
    }

    /// <summary>The same; both halves of a long program are copied concurrently.</summary>
    internal static byte[] Apply(ReadOnlyMemory<byte> bytes, List<NcPatch> patches)
    {
        if (bytes.Length < NcProgram.Many)
        {
            return Apply(bytes.Span, patches);
        }

        // The border is in the middle, or after the patch that spans it.
        var (border, first, shift, growth) = (bytes.Length / 2, 0, 0, 0);
        foreach (ref readonly var patch in CollectionsMarshal.AsSpan(patches))
        {
            growth += patch.Bytes.Length - patch.Length;
            if (patch.Start < bytes.Length / 2)
            {
                (border, first, shift) = (Math.Max(border, patch.Start + patch.Length), first + 1, growth);
            }
        }

        var result = GC.AllocateUninitializedArray<byte>(bytes.Length + growth);
        var behind = Task.Run(() => Copy(bytes.Span, border, CollectionsMarshal.AsSpan(patches)[first..], result.AsSpan(border + shift)));
        Copy(bytes.Span[..border], 0, CollectionsMarshal.AsSpan(patches)[..first], result.AsSpan(0, border + shift));
        behind.GetAwaiter().GetResult();
        return result;
    }

    // Copies the bytes from a position on, patched.
    private static void Copy(ReadOnlySpan<byte> bytes, int from, ReadOnlySpan<NcPatch> patches, Span<byte> result)
    {
        foreach (ref readonly var patch in patches)
        {
            if (patch.Start < from || patch.Start + patch.Length > bytes.Length)
            {
                throw new ArgumentException("Patches must lie inside the program, in ascending order, without overlap.", nameof(patches));
            }

            bytes[from..patch.Start].CopyTo(result);
            result = result[(patch.Start - from)..];
            patch.Bytes.Span.CopyTo(result);
            result = result[patch.Bytes.Length..];
            from = patch.Start + patch.Length;
        }

        bytes[from..].CopyTo(result);
    }
}
