using System.Runtime.CompilerServices;
using ErrorMatching.Cell;

namespace ErrorMatching.Testing;

/// <summary>Hashes passwords with little work, in the tests of the console and of the station. A third of a second of a processor for each
/// sign-in and signature is right at a cell; it was a third of what the console's tests took.</summary>
internal static class QuickPasswords
{
    // Before the tests of this program begin.
#pragma warning disable CA2255 // A program, not a library: this is the one place before its entry.
    [ModuleInitializer]
#pragma warning restore CA2255
    internal static void LowerWork() => PasswordHashes.Usual = 10;
}
