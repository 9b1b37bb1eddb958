using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary>The argument that names a correction.</summary>
internal sealed class IdArgument : Argument<long>
{
    public IdArgument()
        : base("ID") => Description = "Number of the correction, as cell status and cell history print it.";
}
