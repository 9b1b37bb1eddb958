namespace ErrorMatching.Nc;

/// <summary>What an independent judge needs to check that a result differs from its original only as wished, schema
/// <c>errormatch/certificate/1</c>: the hashes of both programs, how the dialect reads them, the wish of each named motion, and how each
/// changed motion moved.</summary>
/// <remarks>The judge is <c>tools/judge.py</c>. It shares no code with this library. Lengths are in mm. Motions are named by line and
/// block.</remarks>
public sealed class Certificate
{
    /// <summary>Name and version of the document.</summary>
    public const string Schema = "errormatch/certificate/1";

    private Certificate(ProofTask task, string? marker, int markerBlock, IReadOnlyList<CertifiedMotion> moved) =>
        (Task, Marker, MarkerBlock, Moved) = (task, marker, markerBlock, moved);

    /// <summary>The comment that was inserted as a separate line; null if there is none.</summary>
    public string? Marker { get; }

    /// <summary>Both programs and the wish.</summary>
    internal ProofTask Task { get; }

    /// <summary>The block of the marker in the result; <see cref="int.MaxValue"/> if there is none.</summary>
    internal int MarkerBlock { get; }

    /// <summary>The named motions and the changed ones, in path order.</summary>
    internal IReadOnlyList<CertifiedMotion> Moved { get; }

    /// <summary>The certificate of a result whose proof holds.</summary>
    /// <param name="before">The original, interpreted.</param>
    /// <param name="result">The result.</param>
    /// <param name="wish">The wish; positions of motions are those of the original.</param>
    /// <param name="leastIncrementMm">Increment to which new coordinates were rounded.</param>
    /// <param name="proof">The proof.</param>
    /// <exception cref="ArgumentException">The proof does not hold.</exception>
    public static Certificate Of(NcPath before, NcProgram result, DisplacementWish wish, double leastIncrementMm, NcProof proof)
    {
        ArgumentNullException.ThrowIfNull(before);
        ArgumentNullException.ThrowIfNull(result);
        ArgumentNullException.ThrowIfNull(wish);
        ArgumentNullException.ThrowIfNull(proof);
        if (!proof.Holds)
        {
            throw new ArgumentException("Only a result whose proof holds has a certificate.", nameof(proof));
        }

        var task = new ProofTask(before, NcInterpreter.Run(result, before), wish, leastIncrementMm);
        var markerBlock = proof.Marker is { } marker ? LineOf(result, marker) : int.MaxValue;
        return new(task, proof.Marker, markerBlock, CertifiedMotions.Of(task, proof, markerBlock));
    }

    /// <summary>The document: UTF-8 without a byte order mark, one moved motion per line. Its last member is the SHA-256 of all bytes
    /// before it.</summary>
    public byte[] ToBytes() => CertificateWriter.Write(this);

    // The first line that consists of the text alone.
    private static int LineOf(NcProgram program, string text)
    {
        for (var i = 0; i < program.BlockCount; i++)
        {
            if (program.TextOf(program[i]) == text)
            {
                return i;
            }
        }

        return int.MaxValue;
    }
}
