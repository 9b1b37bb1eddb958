using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The option that saves a certificate of the result, which <c>tools/judge.py</c> judges with the two programs.</summary>
internal sealed class CertificateOption : Option<string>
{
    public CertificateOption()
        : base("--certificate")
    {
        Description = "The file to write a certificate to, for tools/judge.py.";
        HelpName = "FILE";
    }

    /// <summary>The outputs, preceded by the certificate if requested.</summary>
    /// <param name="files">The outputs; the last one is the program.</param>
    /// <param name="certificate">Creates the certificate.</param>
    /// <param name="arguments">The user's arguments.</param>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> Before(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files, Func<Certificate> certificate, ParseResult arguments) =>
        arguments.GetValue(this) is { } file ? [(file, certificate().ToBytes()), .. files] : files;
}
