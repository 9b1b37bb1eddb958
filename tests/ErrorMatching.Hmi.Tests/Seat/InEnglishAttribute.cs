using System.Reflection;
using ErrorMatching.Hmi.Tests;
using Xunit.Sdk;
using Xunit.v3;

// There is one screen and one language for all tests: what one of them chooses, another one would see.
[assembly: Parallelization(Mode = ParallelMode.None)]
[assembly: InEnglish]

namespace ErrorMatching.Hmi.Tests;

/// <summary>Lets each test begin in English, whatever the one before has chosen.</summary>
[AttributeUsage(AttributeTargets.Assembly)]
internal sealed class InEnglishAttribute : BeforeAfterTestAttribute
{
    public override void Before(MethodInfo methodUnderTest, IXunitTest test) => Texts.Current.Language = Language.English;
}
